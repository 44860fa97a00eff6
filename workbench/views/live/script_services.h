// SPDX-License-Identifier: MIT
// The services of the live view that read, check and write scripts. They take as long as the disk takes, so a viewer's
// own thread calls them, never that of the frames.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "workbench/views/live/requests.h"
#include "workbench/views/live/services.h"

namespace reorient::live {

/// All functions throw std::runtime_error or BadClientMessage with one line. Any thread may call them.
class ScriptServices {
 public:
  /// `root`: the folder of the scripts.
  explicit ScriptServices(std::filesystem::path root) : root_(std::move(root)) {}

  /// The JSON of the response; nothing: the service does not belong to this class.
  std::optional<std::string> answer(Service service, const std::string& payload) const;
  /// The scripts to reload, which the thread of the frames does.
  FrameTask reload(const std::string& payload) const;

 private:
  std::string list() const;
  std::string read(const std::string& payload) const;
  std::string check(const std::string& payload) const;
  std::string save(const std::string& payload) const;

  const std::filesystem::path root_;
  mutable std::mutex checking_;  // held during the only check, because a check takes much time of a processor
  mutable std::mutex saving_;    // held from the comparison with the disk to the end of writing
};

}  // namespace reorient::live
