// SPDX-License-Identifier: MIT
// A recording as tables, for spreadsheets and plots.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.h"

namespace reorient {

/// "world", "events".
std::vector<std::string> csv_topics();

/// world: one line a frame, all that behaviors see, and where the robot really was, where that is known. events: one
/// line for each command and change of state. Throws std::runtime_error with one line: unknown topic.
void write_csv(Recording& recording, std::string_view topic, std::ostream& out);

}  // namespace reorient
