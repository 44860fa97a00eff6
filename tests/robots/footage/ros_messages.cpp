// SPDX-License-Identifier: MIT
#include "tests/robots/footage/ros_messages.h"

#include <algorithm>
#include <array>
#include <bit>

namespace reorient {
namespace {

constexpr std::size_t kEncapsulation = 4;  // bytes

void write(CdrWriter& out, const messages::Header& header) {
  out.number(static_cast<std::int32_t>(header.time / messages::kSecond));
  out.number(static_cast<std::uint32_t>(header.time % messages::kSecond));
  out.text(header.frame);
}

void write(CdrWriter& out, const messages::Quaternion& rotation) {
  out.doubles(std::array{rotation.x, rotation.y, rotation.z, rotation.w});
}

void write(CdrWriter& out, const messages::Motion& motion) {
  out.doubles({motion.translation.data(), 3});
  write(out, motion.rotation);
}

template <std::size_t Size>
void write_zeros(CdrWriter& out) {
  out.doubles(std::array<double, Size>{});
}

}  // namespace

CdrWriter::CdrWriter(ByteOrder order)
    : bytes_{std::byte{0}, static_cast<std::byte>(order == ByteOrder::little ? 1 : 0), std::byte{0}, std::byte{0}},
      reverse_((order == ByteOrder::little) != (std::endian::native == std::endian::little)) {}

void CdrWriter::align(std::size_t size) {
  while ((bytes_.size() - kEncapsulation) % size != 0) bytes_.emplace_back();
}

void CdrWriter::append(const void* value, std::size_t size) {
  const auto* const begin = static_cast<const std::byte*>(value);
  bytes_.insert(bytes_.end(), begin, begin + size);
  if (reverse_) std::reverse(bytes_.end() - static_cast<std::ptrdiff_t>(size), bytes_.end());
}

void CdrWriter::text(const std::string& text) {
  number(static_cast<std::uint32_t>(text.size() + 1));
  const auto characters = std::as_bytes(std::span(text.c_str(), text.size() + 1));
  bytes_.insert(bytes_.end(), characters.begin(), characters.end());
}

void CdrWriter::bytes(std::span<const std::byte> bytes) {
  number(static_cast<std::uint32_t>(bytes.size()));
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void CdrWriter::doubles(std::span<const double> numbers) {
  for (const double each : numbers) number(each);
}

messages::Bytes ros_image(const messages::RawImage& image, ByteOrder order) {
  CdrWriter out(order);
  write(out, image.header);
  out.number(image.height);
  out.number(image.width);
  out.text(image.encoding);
  out.number(std::uint8_t{0});
  out.number(image.step);
  out.bytes(image.data);
  return out.take();
}

messages::Bytes ros_compressed_image(const messages::CompressedImage& image, ByteOrder order) {
  CdrWriter out(order);
  write(out, image.header);
  out.text(image.format);
  out.bytes(image.data);
  return out.take();
}

messages::Bytes ros_camera_info(const messages::CameraInfo& info, ByteOrder order) {
  CdrWriter out(order);
  write(out, info.header);
  out.number(info.height);
  out.number(info.width);
  out.text(info.distortion_model);
  out.number(static_cast<std::uint32_t>(info.d.size()));
  out.doubles(info.d);
  out.doubles(info.k);
  out.doubles(std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  out.doubles(info.p);
  for (const std::uint32_t binning : {0u, 0u}) out.number(binning);
  out.number(info.region.x_offset);
  out.number(info.region.y_offset);
  out.number(info.region.height);
  out.number(info.region.width);
  out.number(false);
  return out.take();
}

messages::Bytes ros_transforms(const messages::Transforms& transforms, ByteOrder order) {
  CdrWriter out(order);
  out.number(static_cast<std::uint32_t>(transforms.transforms.size()));
  for (const messages::Transform& each : transforms.transforms) {
    write(out, each.header);
    out.text(each.child);
    write(out, each.parent_from_child);
  }
  return out.take();
}

messages::Bytes ros_pose_stamped(const messages::Pose& pose, ByteOrder order) {
  CdrWriter out(order);
  write(out, pose.header);
  write(out, pose.pose);
  return out.take();
}

messages::Bytes ros_odometry(const messages::Pose& pose, ByteOrder order) {
  CdrWriter out(order);
  write(out, pose.header);
  out.text(pose.child);
  write(out, pose.pose);
  write_zeros<36>(out);
  write_zeros<6 + 36>(out);
  return out.take();
}

messages::Bytes ros_imu(const messages::Imu& imu, ByteOrder order) {
  CdrWriter out(order);
  write(out, imu.header);
  write(out, imu.orientation.value_or(messages::Quaternion{}));
  std::array<double, 9> covariance{};
  if (!imu.orientation) covariance[0] = -1.0;
  out.doubles(covariance);
  write_zeros<3 + 9 + 3 + 9>(out);
  return out.take();
}

}  // namespace reorient
