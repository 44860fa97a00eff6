// SPDX-License-Identifier: MIT
// The log of the program: one line per message, with the robot's time during a run.
#pragma once

#include <optional>
#include <string>

namespace reorient {

/// Sends the log to the standard error. `level`: a level of spdlog; `color`: always, never or auto. On a terminal a log
/// line replaces the progress line, which is drawn again below it. Text of messages is made one line of visible
/// letters.
void set_up_log(const std::string& level, const std::string& color);

/// The robot's time in s, which begins the following lines; nothing: outside of a run.
void set_log_time(std::optional<double> time);

}  // namespace reorient
