// SPDX-License-Identifier: MIT
// A simulated robot looks around from many positions on the field: the images for scoring the field vision.
#pragma once

#include <cstdint>

#include "perception/field/field_features.h"
#include "robots/simulator/simulator.h"
#include "workbench/simulated_images/percept_score.h"

namespace reorient {

struct LookAround {
  int places = 30;    ///< number of positions, with three images from each
  double gaze = 0.0;  ///< rad/s, rotation speed of the head; 0: still
  std::uint64_t seed = 1;
};

/// Moves robot and ball; the ball is before the robot and within the lines. Uses the true camera pose, so that only the
/// vision is scored. The hall's light changes at each place.
PerceptScore look_around(Simulator& simulator, FieldFeatures& features, const FieldDimensions& field,
                         const FieldFeatureParameters& parameters, const LookAround& look);

}  // namespace reorient
