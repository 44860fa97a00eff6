// SPDX-License-Identifier: MIT
#include "tests/workbench/footage/ros_log_writer.h"

#include <cmath>
#include <utility>

#include "robots/footage/log_frames.h"

namespace reorient {
namespace {

messages::Motion motion_of(const Isometry3& isometry) {
  const Eigen::Quaterniond q(isometry.linear());
  return {isometry.translation(), {q.x(), q.y(), q.z(), q.w()}};
}

messages::CameraInfo info_of(const CameraModel& camera, const messages::Header& header) {
  messages::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(camera.width);
  info.height = static_cast<std::uint32_t>(camera.height);
  info.distortion_model = "plumb_bob";
  info.d = {camera.k1, camera.k2, 0.0, 0.0, 0.0};
  info.k = {camera.focal.x(), 0.0, camera.center.x(), 0.0, camera.focal.y(), camera.center.y(), 0.0, 0.0, 1.0};
  info.p = {
      camera.focal.x(), 0.0, camera.center.x(), 0.0, 0.0, camera.focal.y(), camera.center.y(), 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

}  // namespace

RosLogWriter::RosLogWriter(mcap::Writer::Sink sink, RosLogOptions options)
    : options_(std::move(options)), writer_(std::move(sink), "ros_log_writer") {
  const auto channel = [&](const char* topic, const char* type) {
    return writer_.add_channel(topic, "cdr", writer_.add_schema(type, "ros2msg", ""));
  };
  image_ = options_.encode ? channel("/camera/image_raw/compressed", "sensor_msgs/msg/CompressedImage")
                           : channel("/camera/image_raw", "sensor_msgs/msg/Image");
  camera_info_ = channel("/camera/camera_info", "sensor_msgs/msg/CameraInfo");
  transforms_ = channel("/tf", "tf2_msgs/msg/TFMessage");
  odometry_ = channel("/odom", "nav_msgs/msg/Odometry");
  if (options_.with_imu) imu_ = channel("/imu", "sensor_msgs/msg/Imu");
}

void RosLogWriter::add_image(const FootageFrame& frame, const messages::Header& header, std::uint64_t log_time) {
  if (options_.encode) {
    const messages::CompressedImage compressed{header, options_.format, options_.encode(frame.image)};
    writer_.add_message(image_, log_time, ros_compressed_image(compressed, options_.order));
    return;
  }
  const bool gray = options_.encoding == "mono8";
  messages::RawImage raw{header,
                         static_cast<std::uint32_t>(frame.image.width()),
                         static_cast<std::uint32_t>(frame.image.height()),
                         options_.encoding,
                         0,
                         {}};
  raw.step = (gray ? 1 : 2) * raw.width;
  const std::vector<std::uint8_t>& pixels = frame.image.bytes();
  for (std::size_t i = 0; i < pixels.size(); i += gray ? 2 : 1) raw.data.push_back(static_cast<std::byte>(pixels[i]));
  writer_.add_message(image_, log_time, ros_image(raw, options_.order));
}

void RosLogWriter::add_transforms(const FootageFrame& frame, messages::Time time, std::uint64_t log_time) {
  Isometry3 ground_from_base = Isometry3::Identity();
  ground_from_base.linear() = rotation_about_y(frame.torso.pitch) * rotation_about_x(frame.torso.roll);
  ground_from_base.translation().z() = options_.base_height;
  messages::Transforms all;
  const auto add = [&](const char* parent, const char* child, const Isometry3& parent_from_child) {
    all.transforms.push_back({{time, parent}, child, motion_of(parent_from_child)});
  };
  if (frame.odometry) {
    const Isometry3 odometry_from_base = to_isometry(*frame.odometry) * ground_from_base;
    if (frame.pose) add("map", "odom", to_isometry(*frame.pose * frame.odometry->inverse()));
    add("odom", "base_link", odometry_from_base);
    const messages::Pose pose{{time, "odom"}, "base_link", motion_of(odometry_from_base)};
    writer_.add_message(odometry_, log_time, ros_odometry(pose, options_.order));
  } else if (frame.pose) {
    add("map", "base_link", to_isometry(*frame.pose) * ground_from_base);
  }
  add("base_link", "camera_optical_frame", ground_from_base.inverse() * frame.robot_from_camera * body_from_optical());
  writer_.add_message(transforms_, log_time, ros_transforms(all, options_.order));
  if (options_.with_imu) {
    const messages::Imu imu{{time, "base_link"}, motion_of(ground_from_base).rotation};
    writer_.add_message(imu_, log_time, ros_imu(imu, options_.order));
  }
}

void RosLogWriter::add(const FootageFrame& frame) {
  const auto time =
      static_cast<messages::Time>(std::llround(1e9 * frame.time)) + static_cast<messages::Time>(1e9 * options_.start);
  const messages::Header header{time, "camera_optical_frame"};
  // An image takes longer to arrive than what was measured at the same time.
  const auto log_time = static_cast<std::uint64_t>(time) + 1000000;
  add_transforms(frame, time, log_time);
  writer_.add_message(camera_info_, log_time, ros_camera_info(info_of(frame.camera, header), options_.order));
  add_image(frame, header, log_time + 20000000);
  constexpr std::size_t kChunk = 768u << 10;  // bytes, as rosbag2 has them
  if (writer_.waiting() >= kChunk) writer_.close_chunk();
}

std::vector<std::byte> ros_log(const std::vector<FootageFrame>& frames, const RosLogOptions& options) {
  std::vector<std::byte> file;
  RosLogWriter writer([&](std::span<const std::byte> bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); },
                      options);
  for (const FootageFrame& frame : frames) writer.add(frame);
  writer.finish();
  return file;
}

}  // namespace reorient
