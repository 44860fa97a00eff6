// The pose particles just before and just after commands (the paper's Fig. 6).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient::pictures {

struct PoseSnapshot {
  std::vector<Pose2> particles;
  std::optional<Pose2> truth;
  std::optional<Pose2> belief;
};

struct ReorientationPanels {
  std::string command;  ///< e.g. "flip"
  double time = 0.0;    ///< s
  PoseSnapshot before;
  PoseSnapshot after;
};

/// One line of two panels a command, the first ten of them.
Picture draw_reorientation_view(const FieldDimensions& field, const std::vector<ReorientationPanels>& reorientations);

}  // namespace reorient::pictures
