// SPDX-License-Identifier: MIT
// Times of a recording from the command line, in s of the robot.
#pragma once

#include <iosfwd>
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

// Throw std::runtime_error with one line if the time is outside of the recording. `--to` may be later than its end,
// which is reported on `err`.
void require_recorded(const Recording& recording, const RecordedTimes& times, std::ostream& err);
void require_recorded(const Recording& recording, double at);

}  // namespace reorient
