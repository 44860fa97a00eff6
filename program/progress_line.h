// SPDX-License-Identifier: MIT
// The progress of a long command, for the user: a line that a terminal overwrites, otherwise a line every ten seconds.
#pragma once

#include <chrono>
#include <iosfwd>
#include <string_view>

namespace reorient {

class ProgressLine {
 public:
  /// `pause`: shortest time between two changes of the line on a terminal.
  explicit ProgressLine(std::ostream& err, std::chrono::milliseconds pause = {});
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// The next line is due after a whole pause.
  void restart();
  bool is_due() const { return Clock::now() >= next_; }
  /// Shows the text as one line, and restarts the pause.
  void show(std::string_view text);
  /// Call before another part of the program writes a line.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  std::ostream& err_;
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::milliseconds pause_;
  Clock::time_point next_;
};

}  // namespace reorient
