// SPDX-License-Identifier: MIT
// Writes messages in the format of ROS 2 (CDR), little- or big-endian. Values that the structs do not contain are
// written as 0 or identity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "robots/footage/messages/messages.h"

namespace reorient {

enum class ByteOrder { little, big };

/// Appends values aligned to their size.
class CdrWriter {
 public:
  explicit CdrWriter(ByteOrder order);

  template <typename T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    align(sizeof(T));
    append(&value, sizeof(T));
  }
  void text(const std::string& text);
  void bytes(std::span<const std::byte> bytes);
  void doubles(std::span<const double> numbers);  ///< without a length

  messages::Bytes take() { return std::move(bytes_); }

 private:
  void align(std::size_t size);
  void append(const void* value, std::size_t size);

  messages::Bytes bytes_;
  bool reverse_;
};

messages::Bytes ros_image(const messages::RawImage& image, ByteOrder order = ByteOrder::little);
messages::Bytes ros_compressed_image(const messages::CompressedImage& image, ByteOrder order = ByteOrder::little);
messages::Bytes ros_camera_info(const messages::CameraInfo& info, ByteOrder order = ByteOrder::little);
messages::Bytes ros_transforms(const messages::Transforms& transforms, ByteOrder order = ByteOrder::little);
messages::Bytes ros_pose_stamped(const messages::Pose& pose, ByteOrder order = ByteOrder::little);
messages::Bytes ros_odometry(const messages::Pose& pose, ByteOrder order = ByteOrder::little);
messages::Bytes ros_imu(const messages::Imu& imu, ByteOrder order = ByteOrder::little);

}  // namespace reorient
