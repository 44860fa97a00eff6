// SPDX-License-Identifier: MIT
// The message types that footage can be read from, and what each is good for.
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
  std::string_view schema;    ///< as in the file: "sensor_msgs/msg/Image"
  std::string_view encoding;  ///< "cdr", "json", "protobuf"
  Content content;
  Message (*decode)(std::span<const std::byte> message);  ///< throws BadFootage
};

std::span<const MessageType> message_types();

/// Null: not read here. ROS names are accepted without "/msg/", too.
const MessageType* find_message_type(std::string_view schema, std::string_view encoding);
/// Whether it is read in some encoding; which, for an error message: "cdr", "json or protobuf".
std::string encodings_of(std::string_view schema);

}  // namespace reorient::messages
