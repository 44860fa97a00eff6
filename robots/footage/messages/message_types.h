// SPDX-License-Identifier: MIT
// The message types from which footage can be read, and the data that each contains.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "robots/footage/messages/messages.h"

namespace reorient::messages {

enum class Content { image, camera_info, transforms, pose, odometry, imu };
constexpr int enum_count(Content) { return 6; }
const char* name_of(Content content);  ///< "image topic" ...

struct MessageType {
  std::string_view schema;    ///< name in the file: "sensor_msgs/msg/Image"
  std::string_view encoding;  ///< "cdr", "json", "protobuf"
  Content content;
  Message (*decode)(std::span<const std::byte> message);  ///< throws BadFootage
};

std::span<const MessageType> message_types();

/// Null: the type is not supported. ROS names are also accepted without "/msg/".
const MessageType* find_message_type(std::string_view schema, std::string_view encoding);
/// The supported encodings of a schema, for an error message: "cdr", "json or protobuf"; empty: not supported.
std::string encodings_of(std::string_view schema);

}  // namespace reorient::messages
