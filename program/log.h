// SPDX-License-Identifier: MIT
// The log of the program: one line per message, with the robot's time during a run.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <spdlog/sinks/sink.h>

namespace reorient {

/// Sends the log to the standard error. `level`: a level of spdlog; `color`: always, never or auto. On a terminal a log
/// line replaces the progress line, which is drawn again below it. Text of messages is made one line of visible
/// letters.
void set_up_log(const std::string& level, const std::string& color);

/// While it exists, complete lines of the log, with their line ends and colors, go to a function instead of the
/// standard error. The function may be called on any thread, one call at a time.
class LogRedirection {
 public:
  explicit LogRedirection(std::function<void(std::string_view line)> write);
  ~LogRedirection();
  LogRedirection(const LogRedirection&) = delete;
  LogRedirection& operator=(const LogRedirection&) = delete;

 private:
  std::shared_ptr<spdlog::sinks::sink> before_;
};

/// The robot's time in s, which begins the following lines; nothing: outside of a run.
void set_log_time(std::optional<double> time);

}  // namespace reorient
