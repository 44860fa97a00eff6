// SPDX-License-Identifier: MIT
// The topics of a log that are used as footage.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robots/footage/messages/message_types.h"
#include "robots/footage/transform_tree.h"
#include "workbench/recording/mcap/contents.h"

namespace reorient {

/// A topic by its name. Nothing: it is chosen (see choose_topics()); an empty name: none is used.
struct LogTopics {
  std::optional<std::string> image;
  std::optional<std::string> camera_info;
  std::optional<std::vector<std::string>> transforms;
  std::optional<std::string> pose;      ///< of the robot in the field; odometry messages are accepted, too
  std::optional<std::string> odometry;  ///< pose messages are accepted, too
  std::optional<std::string> imu;
};

/// A channel of the file that is used.
struct LogChannel {
  std::string topic;
  const messages::MessageType* type = nullptr;
  std::vector<messages::Content> uses;
  TransformTree::Validity validity = TransformTree::Validity::limited;  ///< of transforms
  bool rectified = false;                                               ///< of images, by the name of the topic
};

struct ChosenTopics {
  std::map<std::uint16_t, LogChannel> channels;  ///< by number in the file
  std::vector<std::string> lines;  ///< for the user: "image: /camera/image_raw (sensor_msgs/msg/Image, cdr)"

  bool has(messages::Content content) const;
};

/// Chooses topics that have messages: all with transforms, the camera info in the namespace of the image, else the only
/// one, and the only one of each other kind; a topic named as pose is not chosen as odometry. The topics of goals
/// (goal_pose, initialpose) are never chosen as poses. Several pose topics beside transforms: none is chosen.
///
/// Throws BadFootage with a list if several other topics of a kind exist, if a named topic does not fit, or if image or
/// camera info (`needs_camera_info`) are missing.
ChosenTopics choose_topics(const mcap::Contents& contents, const LogTopics& wanted, bool needs_camera_info);

}  // namespace reorient
