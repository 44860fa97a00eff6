// SPDX-License-Identifier: MIT
#include "robots/footage/messages/foxglove_protobuf.h"

#include "robots/footage/messages/bad_message.h"
#include "robots/footage/messages/protobuf_reader.h"

namespace reorient::messages::foxglove_protobuf {
namespace {

/// google.protobuf.Timestamp.
Time read_time(ProtobufReader in) {
  std::int64_t seconds = 0, nanoseconds = 0;
  while (in.next()) {
    if (in.field() == 1) seconds = in.integer("timestamp.seconds");
    if (in.field() == 2) nanoseconds = in.integer("timestamp.nanos");
  }
  constexpr std::int64_t kLatest = 4000000000;  // s
  if (seconds < 0 || seconds > kLatest || nanoseconds < 0 || nanoseconds >= kSecond) {
    fail_at(in.offset(), "timestamp: expected 0 to 4000000000 s and 0 to 999999999 ns, found " +
                             std::to_string(seconds) + " s and " + std::to_string(nanoseconds) + " ns");
  }
  return seconds * kSecond + nanoseconds;
}

/// Reads Vector3 and Quaternion, whose fields have the numbers 1, 2, ...
template <std::size_t Size>
std::array<double, Size> read_numbers(ProtobufReader in, const char* what) {
  std::array<double, Size> numbers{};
  while (in.next())
    if (in.field() <= Size) numbers[in.field() - 1] = in.number(what);
  return numbers;
}

Eigen::Vector3d read_vector(const ProtobufReader& in, const char* what) {
  return Eigen::Vector3d(read_numbers<3>(in, what).data());
}

Quaternion read_quaternion(const ProtobufReader& in, const char* what) {
  const auto [x, y, z, w] = read_numbers<4>(in, what);
  return {x, y, z, w};
}

Motion read_pose(ProtobufReader in) {
  Motion pose;
  while (in.next()) {
    if (in.field() == 1) pose.translation = read_vector(in.message("pose.position"), "pose.position");
    if (in.field() == 2) pose.rotation = read_quaternion(in.message("pose.orientation"), "pose.orientation");
  }
  return pose;
}

Transform read_transform(ProtobufReader in) {
  Transform transform;
  while (in.next()) {
    if (in.field() == 1) transform.header.time = read_time(in.message("timestamp"));
    if (in.field() == 2) transform.header.frame = in.text("parent_frame_id");
    if (in.field() == 3) transform.child = in.text("child_frame_id");
    if (in.field() == 4)
      transform.parent_from_child.translation = read_vector(in.message("translation"), "translation");
    if (in.field() == 5) transform.parent_from_child.rotation = read_quaternion(in.message("rotation"), "rotation");
  }
  return transform;
}

void assign(Bytes& bytes, std::span<const std::byte> found) { bytes.assign(found.begin(), found.end()); }

}  // namespace

RawImage raw_image(std::span<const std::byte> message) {
  ProtobufReader in(message);
  RawImage image;
  while (in.next()) {
    if (in.field() == 1) image.header.time = read_time(in.message("timestamp"));
    if (in.field() == 2) image.width = in.fixed32("width");
    if (in.field() == 3) image.height = in.fixed32("height");
    if (in.field() == 4) image.encoding = in.text("encoding");
    if (in.field() == 5) image.step = in.fixed32("step");
    if (in.field() == 6) assign(image.data, in.bytes("data"));
    if (in.field() == 7) image.header.frame = in.text("frame_id");
  }
  return image;
}

CompressedImage compressed_image(std::span<const std::byte> message) {
  ProtobufReader in(message);
  CompressedImage image;
  while (in.next()) {
    if (in.field() == 1) image.header.time = read_time(in.message("timestamp"));
    if (in.field() == 2) assign(image.data, in.bytes("data"));
    if (in.field() == 3) image.format = in.text("format");
    if (in.field() == 4) image.header.frame = in.text("frame_id");
  }
  return image;
}

CameraInfo camera_calibration(std::span<const std::byte> message) {
  ProtobufReader in(message);
  CameraInfo info;
  std::vector<double> k, p;
  while (in.next()) {
    if (in.field() == 1) info.header.time = read_time(in.message("timestamp"));
    if (in.field() == 2) info.width = in.fixed32("width");
    if (in.field() == 3) info.height = in.fixed32("height");
    if (in.field() == 4) info.distortion_model = in.text("distortion_model");
    if (in.field() == 5) in.append_numbers(info.d, "D");
    if (in.field() == 6) in.append_numbers(k, "K");
    if (in.field() == 8) in.append_numbers(p, "P");
    if (in.field() == 9) info.header.frame = in.text("frame_id");
  }
  info.k = matrix_of<9>(k, "K");
  info.p = matrix_of<12>(p, "P");
  return info;
}

Transforms frame_transform(std::span<const std::byte> message) {
  Transforms all;
  all.transforms.push_back(read_transform(ProtobufReader(message)));
  return all;
}

Transforms frame_transforms(std::span<const std::byte> message) {
  ProtobufReader in(message);
  Transforms all;
  while (in.next()) {
    if (in.field() != 1) continue;
    if (all.transforms.size() == kMostTransforms)
      fail_at(in.offset(), "transforms: expected at most 100000, found more");
    all.transforms.push_back(read_transform(in.message("transforms")));
  }
  return all;
}

Pose pose_in_frame(std::span<const std::byte> message) {
  ProtobufReader in(message);
  Pose pose;
  while (in.next()) {
    if (in.field() == 1) pose.header.time = read_time(in.message("timestamp"));
    if (in.field() == 2) pose.header.frame = in.text("frame_id");
    if (in.field() == 3) pose.pose = read_pose(in.message("pose"));
  }
  return pose;
}

}  // namespace reorient::messages::foxglove_protobuf
