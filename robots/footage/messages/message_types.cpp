// SPDX-License-Identifier: MIT
#include "robots/footage/messages/message_types.h"

#include <algorithm>
#include <array>

#include "robots/footage/messages/foxglove_json.h"
#include "robots/footage/messages/foxglove_protobuf.h"
#include "robots/footage/messages/ros.h"

namespace reorient::messages {
namespace {

template <auto Decode>
Message decoded(std::span<const std::byte> message) {
  return Decode(message);
}

constexpr std::string_view kCdr = "cdr", kJson = "json", kProtobuf = "protobuf";

constexpr std::array kTypes = std::to_array<MessageType>({
    {"sensor_msgs/msg/Image", kCdr, Content::image, decoded<ros::image>},
    {"sensor_msgs/msg/CompressedImage", kCdr, Content::image, decoded<ros::compressed_image>},
    {"sensor_msgs/msg/CameraInfo", kCdr, Content::camera_info, decoded<ros::camera_info>},
    {"tf2_msgs/msg/TFMessage", kCdr, Content::transforms, decoded<ros::transforms>},
    {"geometry_msgs/msg/PoseStamped", kCdr, Content::pose, decoded<ros::pose_stamped>},
    {"geometry_msgs/msg/PoseWithCovarianceStamped", kCdr, Content::pose, decoded<ros::pose_with_covariance_stamped>},
    {"nav_msgs/msg/Odometry", kCdr, Content::odometry, decoded<ros::odometry>},
    {"sensor_msgs/msg/Imu", kCdr, Content::imu, decoded<ros::imu>},
    {"foxglove.RawImage", kJson, Content::image, decoded<foxglove_json::raw_image>},
    {"foxglove.CompressedImage", kJson, Content::image, decoded<foxglove_json::compressed_image>},
    {"foxglove.CameraCalibration", kJson, Content::camera_info, decoded<foxglove_json::camera_calibration>},
    {"foxglove.FrameTransform", kJson, Content::transforms, decoded<foxglove_json::frame_transform>},
    {"foxglove.FrameTransforms", kJson, Content::transforms, decoded<foxglove_json::frame_transforms>},
    {"foxglove.PoseInFrame", kJson, Content::pose, decoded<foxglove_json::pose_in_frame>},
    {"foxglove.RawImage", kProtobuf, Content::image, decoded<foxglove_protobuf::raw_image>},
    {"foxglove.CompressedImage", kProtobuf, Content::image, decoded<foxglove_protobuf::compressed_image>},
    {"foxglove.CameraCalibration", kProtobuf, Content::camera_info, decoded<foxglove_protobuf::camera_calibration>},
    {"foxglove.FrameTransform", kProtobuf, Content::transforms, decoded<foxglove_protobuf::frame_transform>},
    {"foxglove.FrameTransforms", kProtobuf, Content::transforms, decoded<foxglove_protobuf::frame_transforms>},
    {"foxglove.PoseInFrame", kProtobuf, Content::pose, decoded<foxglove_protobuf::pose_in_frame>},
});

/// Whether a schema names the type. Some writers write "sensor_msgs/Image" for "sensor_msgs/msg/Image".
bool is_named(const MessageType& type, std::string_view schema) {
  if (type.schema == schema) return true;
  constexpr std::string_view kMiddle = "/msg/";
  const std::size_t middle = type.schema.find(kMiddle);
  if (middle == std::string_view::npos || schema.size() + kMiddle.size() - 1 != type.schema.size()) return false;
  return schema.substr(0, middle) == type.schema.substr(0, middle) &&
         schema.substr(middle + 1) == type.schema.substr(middle + kMiddle.size()) && schema[middle] == '/';
}

}  // namespace

const char* name_of(Content content) {
  constexpr std::array kNames{"image", "camera info", "transform", "pose", "odometry", "imu"};
  return kNames[static_cast<std::size_t>(content)];
}

std::span<const MessageType> message_types() { return kTypes; }

const MessageType* find_message_type(std::string_view schema, std::string_view encoding) {
  const auto* const it = std::find_if(kTypes.begin(), kTypes.end(), [&](const MessageType& type) {
    return type.encoding == encoding && is_named(type, schema);
  });
  return it == kTypes.end() ? nullptr : &*it;
}

std::string encodings_of(std::string_view schema) {
  std::string all;
  for (const MessageType& type : kTypes) {
    if (!is_named(type, schema)) continue;
    if (!all.empty()) all += " or ";
    all += type.encoding;
  }
  return all;
}

}  // namespace reorient::messages
