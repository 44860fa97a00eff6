// The confidences in the current and in the opposite pose over time (the paper's Fig. 4c).
#pragma once

#include <string>
#include <vector>

#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

/// Confidences are in [0, 1]; one that is not finite leaves a gap.
struct ConfidenceSample {
  double time = 0.0;  ///< s
  double current = 0.0;
  double opposite = 0.0;
  double raw_current = 0.0;
  double raw_opposite = 0.0;
};

struct CommandMark {
  double time = 0.0;    ///< s
  std::string label;    ///< e.g. "flip"
  bool granted = true;  ///< false: refused, drawn dashed
};

enum class Condition { training, training_paused, evaluation_paused, belief_reflected, carried, fallen };

struct ConditionInterval {
  Condition condition = Condition::training;
  double from = 0.0;  ///< s
  double to = 0.0;    ///< s
};

/// All in the order of time. Conditions get a lane each below the curves; while the robot is carried or fallen, the
/// curves' ground is shaded as well.
struct ConfidencePlot {
  std::vector<ConfidenceSample> samples;
  std::vector<CommandMark> commands;
  std::vector<ConditionInterval> conditions;
};

Picture draw_confidence_plot(const ConfidencePlot& plot);

}  // namespace reorient::pictures
