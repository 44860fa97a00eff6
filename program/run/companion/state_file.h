// SPDX-License-Identifier: MIT
// The state of a companion in a file: the next process continues from it, as if it had only been slow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "program/background_writing.h"
#include "robots/companion/companion.h"

namespace reorient {

/// In a shared folder another user may create a link to a file that must not be overwritten. Throws
/// std::runtime_error with one line.
void require_no_link(const std::filesystem::path& file);

/// FILE.other: where the state of another robot lies.
std::filesystem::path aside_of(const std::filesystem::path& file);

/// Saves once a second, and inputs that a client sends once and commands at once. Frames do not wait for the disk, but
/// commands do: the client gets a command only when the state is stored in which it was decided. Otherwise a process
/// that is killed in between would decide it again, and two flips cancel out.
class StateKeeper {
 public:
  /// `circumstances`: equal for two processes that continue from each other; begins with the version and a space.
  StateKeeper(std::filesystem::path file, std::string circumstances);

  /// Between two frames; `now`: s, of a monotonic clock. `is_urgent`: the previous frame contained an initial pose,
  /// which is sent once; if each frame does, the state is saved ten times a second.
  void keep(const FrameLoop& engine, Companion& companion, double now, bool is_urgent);
  /// Before each answer: releases the command whose state was written meanwhile. If it could not be written, releases
  /// it as well: a full disk must not keep the belief wrong.
  void release_command(Companion& companion);
  /// Saves the final state when the run ends.
  void finish(const FrameLoop& engine, Companion& companion);

  /// Restores an engine, and a companion with its handshake. Nothing: the file is missing, or `why_not` contains a
  /// short reason. The first save moves the state of another robot to FILE.other, where it is searched, too. If that
  /// fails, a warning is logged and the state is lost.
  std::unique_ptr<FrameLoop> restore(Companion& companion, std::string& why_not);

 private:
  std::vector<std::byte> bytes_of(const FrameLoop& engine, Companion& companion) const;
  std::filesystem::path aside() const { return aside_of(file_); }
  std::unique_ptr<FrameLoop> read(const std::filesystem::path& file, Companion& companion, std::string& why_not);
  void begin_writing(const FrameLoop& engine, Companion& companion);

  std::filesystem::path file_;
  std::string circumstances_;
  bool is_of_another_ = false;  // the file contains another robot's state, which has not been moved yet
  double last_ = -1e9;          // s, time of the last save
  bool is_urgent_ = false;      // a save was urgent since then
  std::optional<std::uint32_t> writing_command_;  // its decision is in the state that is being written
  BackgroundWriting writing_;
};

}  // namespace reorient
