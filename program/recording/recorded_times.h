// SPDX-License-Identifier: MIT
// Moments of a recording as a person names them, in s of the robot.
#pragma once

#include <limits>

#include "workbench/recording/recording.h"

namespace CLI {
class App;
}

namespace reorient {

/// A part of a recording; by default all of it.
struct RecordedTimes {
  double from = 0.0, to = std::numeric_limits<double>::infinity();
};
/// `--from` and `--to`.
void add_time_options(CLI::App& parser, RecordedTimes& times);

// Throw std::runtime_error with one line where nothing was recorded then.
void require_recorded(const Recording& recording, const RecordedTimes& times);
void require_recorded(const Recording& recording, double at);

}  // namespace reorient
