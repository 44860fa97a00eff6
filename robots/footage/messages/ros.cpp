// SPDX-License-Identifier: MIT
#include "robots/footage/messages/ros.h"

#include "robots/footage/messages/cdr.h"

namespace reorient::messages::ros {
namespace {

Header read_header(CdrReader& in) {
  const auto seconds = in.number<std::int32_t>("stamp.sec");
  const auto nanoseconds = in.number<std::uint32_t>("stamp.nanosec");
  return {Time{seconds} * kSecond + nanoseconds, in.text("frame_id")};
}

Eigen::Vector3d read_vector(CdrReader& in, const char* what) { return Eigen::Vector3d(in.doubles<3>(what).data()); }

Quaternion read_quaternion(CdrReader& in, const char* what) {
  const auto [x, y, z, w] = in.doubles<4>(what);
  return {x, y, z, w};
}

Motion read_motion(CdrReader& in, const char* translation, const char* rotation) {
  Motion motion;
  motion.translation = read_vector(in, translation);
  motion.rotation = read_quaternion(in, rotation);
  return motion;
}

Pose read_pose(CdrReader& in, bool has_child) {
  Pose pose;
  pose.header = read_header(in);
  if (has_child) pose.child = in.text("child_frame_id");
  pose.pose = read_motion(in, "pose.position", "pose.orientation");
  return pose;
}

}  // namespace

RawImage image(std::span<const std::byte> message) {
  CdrReader in(message);
  RawImage image;
  image.header = read_header(in);
  image.height = in.number<std::uint32_t>("height");
  image.width = in.number<std::uint32_t>("width");
  image.encoding = in.text("encoding");
  in.number<std::uint8_t>("is_bigendian");
  image.step = in.number<std::uint32_t>("step");
  const std::span<const std::byte> data = in.bytes("data");
  image.data.assign(data.begin(), data.end());
  return image;
}

CompressedImage compressed_image(std::span<const std::byte> message) {
  CdrReader in(message);
  CompressedImage image;
  image.header = read_header(in);
  image.format = in.text("format");
  const std::span<const std::byte> data = in.bytes("data");
  image.data.assign(data.begin(), data.end());
  return image;
}

CameraInfo camera_info(std::span<const std::byte> message) {
  CdrReader in(message);
  CameraInfo info;
  info.header = read_header(in);
  info.height = in.number<std::uint32_t>("height");
  info.width = in.number<std::uint32_t>("width");
  info.distortion_model = in.text("distortion_model");
  info.d = in.double_sequence("d");
  info.k = in.doubles<9>("k");
  in.doubles<9>("r");
  info.p = in.doubles<12>("p");
  in.number<std::uint32_t>("binning_x");  // not needed, because the image has its own size
  in.number<std::uint32_t>("binning_y");
  info.region.x_offset = in.number<std::uint32_t>("roi.x_offset");
  info.region.y_offset = in.number<std::uint32_t>("roi.y_offset");
  info.region.height = in.number<std::uint32_t>("roi.height");
  info.region.width = in.number<std::uint32_t>("roi.width");
  in.number<bool>("roi.do_rectify");
  return info;
}

Transforms transforms(std::span<const std::byte> message) {
  constexpr std::size_t kLeast = 4 + 4 + 4 + 4 + 7 * 8;  // bytes of one with empty names
  CdrReader in(message);
  Transforms all;
  const std::size_t length = in.sequence_length(kLeast, "transforms");
  all.transforms.reserve(length);
  for (std::size_t i = 0; i < length; ++i) {
    Transform transform;
    transform.header = read_header(in);
    transform.child = in.text("child_frame_id");
    transform.parent_from_child = read_motion(in, "transform.translation", "transform.rotation");
    all.transforms.push_back(std::move(transform));
  }
  return all;
}

Pose pose_stamped(std::span<const std::byte> message) {
  CdrReader in(message);
  return read_pose(in, false);
}

Pose pose_with_covariance_stamped(std::span<const std::byte> message) {
  CdrReader in(message);
  Pose pose = read_pose(in, false);
  in.doubles<36>("pose.covariance");
  return pose;
}

Pose odometry(std::span<const std::byte> message) {
  CdrReader in(message);
  Pose pose = read_pose(in, true);
  in.doubles<36>("pose.covariance");
  in.doubles<6>("twist.twist");
  in.doubles<36>("twist.covariance");
  return pose;
}

Imu imu(std::span<const std::byte> message) {
  CdrReader in(message);
  Imu imu;
  imu.header = read_header(in);
  const Quaternion orientation = read_quaternion(in, "orientation");
  const std::array<double, 9> covariance = in.doubles<9>("orientation_covariance");
  in.doubles<3>("angular_velocity");
  in.doubles<9>("angular_velocity_covariance");
  in.doubles<3>("linear_acceleration");
  in.doubles<9>("linear_acceleration_covariance");
  constexpr double kNotEstimated = -1.0;  // in covariance[0], by the definition of the message
  if (covariance[0] != kNotEstimated) imu.orientation = orientation;
  return imu;
}

}  // namespace reorient::messages::ros
