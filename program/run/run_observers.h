// SPDX-License-Identifier: MIT
// The output of a run while it runs: the progress line and the log.
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>

#include <spdlog/sinks/sink.h>

#include "workbench/run/observer.h"

namespace reorient {

/// One line on `err` that a terminal overwrites; without a terminal a line for every ten seconds of the robot's time.
class Progress : public Observer {
 public:
  /// `is_hidden`: true while another part of the program uses the terminal.
  explicit Progress(std::ostream& err, std::function<bool()> is_hidden = {});

  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  /// Call before another part of the program writes a line; the progress line is then drawn below it.
  void make_room();
  void end();

 private:
  std::ostream& err_;
  bool terminal_;
  std::function<bool()> is_hidden_;
  double next_ = 0.0;
  std::optional<double> first_time_;  // s
  std::chrono::steady_clock::time_point start_;
};

/// While it exists, the terminal is cleared for each line of the log.
class RoomForLog {
 public:
  explicit RoomForLog(std::function<void()> make_room);
  ~RoomForLog();
  RoomForLog(const RoomForLog&) = delete;
  RoomForLog& operator=(const RoomForLog&) = delete;

 private:
  std::shared_ptr<spdlog::sinks::sink> sink_;
};

/// Log lines and errors of scripts, results of edits, and once a second, for debugging, belief and truth.
class RunLog : public Observer {
 public:
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  int reloads_accepted() const { return accepted_; }
  int reloads_rejected() const { return rejected_; }

 private:
  int accepted_ = 0;
  int rejected_ = 0;
};

}  // namespace reorient
