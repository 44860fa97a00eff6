// SPDX-License-Identifier: MIT
// Logs of other robots in MCAP files, ROS 2 or Foxglove, as footage.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robots/footage/footage.h"
#include "robots/footage/log_frames.h"
#include "workbench/footage/log_topics.h"
#include "workbench/recording/mcap/ordered_messages.h"
#include "workbench/recording/mcap/source.h"

namespace reorient {

struct McapLogOptions {
  LogTopics topics;
  /// `base_from_camera`: used if no topic has transforms: the camera is level, 0.5 m above the base frame, and
  /// looks along its x axis. Sets `prefer_pose_topic` if a pose topic is named.
  LogFrameOptions frames;
};

/// Reads a file chunk by chunk, so that any size fits into memory. For a damaged file, returns the frames before the
/// damage, then throws BadFootage.
class McapLog : public FootageSource {
 public:
  /// Throws BadFootage if the file is not an MCAP file, or its topics cannot be chosen.
  McapLog(const std::filesystem::path& file, McapLogOptions options);
  /// `name` of the log, for errors.
  McapLog(std::unique_ptr<mcap::Source> source, std::string name, McapLogOptions options);

  bool next(FootageFrame& frame) override;

  const LogCounts& counts() const { return frames_->counts(); }
  /// The topics in use, a line each.
  const std::vector<std::string>& choices() const { return topics_.lines; }

 private:
  void open(McapLogOptions options);
  void read_message();

  std::unique_ptr<mcap::Source> source_;
  std::string name_;
  ChosenTopics topics_;
  std::optional<mcap::OrderedMessages> messages_;
  std::optional<LogFrames> frames_;
  std::map<std::uint16_t, std::uint64_t> message_counts_;  // by channel
  std::string damage_;                                     // reported after all frames before it
  std::string failure_;                                    // already reported
  bool ended_ = false;
};

}  // namespace reorient
