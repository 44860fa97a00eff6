// SPDX-License-Identifier: MIT
// The progress of many trials, for the user.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>

#include "program/progress_line.h"

namespace reorient {

/// Shows how many trials are complete, and the remaining time.
class Countdown {
 public:
  Countdown(std::ostream& err, std::size_t tasks);

  void count();
  /// Call before another part of the program writes a line.
  void clear() { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;

  ProgressLine line_;
  std::size_t tasks_;
  std::size_t done_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace reorient
