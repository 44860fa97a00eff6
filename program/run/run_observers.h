// What a person sees of a run while it goes on: the progress line, and the log.
#pragma once

#include <chrono>
#include <iosfwd>

#include "workbench/run/observer.h"

namespace reorient {

/// One line on `err` that a terminal overwrites; without a terminal a line for every ten seconds of the robot's time.
class Progress : public Observer {
 public:
  explicit Progress(std::ostream& err);

  void observe(const FrameRecord& frame, const StageRecord& stage) override;
  /// While it is hidden the terminal belongs to somebody else.
  void hide(bool hidden) { hidden_ = hidden; }
  /// For a line of somebody else; the progress line is drawn again below it.
  void make_room();
  void end();

 private:
  std::ostream& err_;
  bool terminal_;
  bool hidden_ = false;
  double next_ = 0.0;
  std::chrono::steady_clock::time_point start_;
};

/// Log lines and errors of scripts, what became of edits, and once a second, for debugging, belief and truth.
class RunLog : public Observer {
 public:
  void observe(const FrameRecord& frame, const StageRecord& stage) override;

  int reloads_accepted() const { return accepted_; }
  int reloads_rejected() const { return rejected_; }

 private:
  void log_reloads(const std::vector<ReloadRecord>& reloads);

  int accepted_ = 0;
  int rejected_ = 0;
};

}  // namespace reorient
