// SPDX-License-Identifier: MIT
// The confidences in the believed and in the mirrored pose over time (the paper's Fig. 4c), and what behaviors decide
// on: the evidence, its threshold, and the status of the room.
#pragma once

#include <string>
#include <vector>

#include "workbench/run/run_history.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

struct CommandMark {
  double time = 0.0;    ///< s
  std::string label;    ///< e.g. "flip"
  bool granted = true;  ///< false: refused, drawn dashed
};

/// All in the order of time. Each condition has a lane below the curves. While the robot is lifted or fallen, the
/// background of the curves is shaded, too.
struct ConfidencePlot {
  std::vector<ConfidencePoint> samples;  ///< in [0, 1]; a confidence that is not finite leaves a gap
  std::vector<CommandMark> commands;
  std::vector<ConditionInterval> conditions;
};

ConfidencePlot confidence_plot_of(const RunHistory& history);

Picture draw_confidence_plot(const ConfidencePlot& plot);

}  // namespace reorient::pictures
