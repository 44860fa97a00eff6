// SPDX-License-Identifier: MIT
// The progress of many trials, for the user.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>

namespace reorient {

/// Prints the progress and the remaining time: a line that a terminal overwrites, otherwise a line every ten seconds.
class Countdown {
 public:
  Countdown(std::ostream& err, std::size_t tasks);
  ~Countdown() { clear(); }
  Countdown(const Countdown&) = delete;
  Countdown& operator=(const Countdown&) = delete;

  void count();
  /// Call before another part of the program writes a line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kPause = 10.0;  // s

  std::ostream& err_;
  std::size_t tasks_;
  std::size_t done_ = 0;
  Clock::time_point start_;
  double next_ = kPause;  ///< s since the start
  bool is_terminal_;
  bool is_shown_ = false;
};

}  // namespace reorient
