// SPDX-License-Identifier: MIT
// A simulated robot looks about from many places of the field: the images on which the field vision is measured.
#pragma once

#include <cstdint>

#include "perception/field/field_features.h"
#include "robots/simulator/simulator.h"
#include "workbench/simulated_images/percept_score.h"

namespace reorient {

struct LookAround {
  int places = 30;    ///< from each the robot takes three images
  double gaze = 0.0;  ///< rad/s, how fast the head turns meanwhile; 0: it stands still
  std::uint64_t seed = 1;
};

/// Moves robot and ball about, the ball before the robot and within the lines. With the true place of the camera, so
/// that the vision is measured alone. The hall's light changes at each place.
PerceptScore look_around(Simulator& simulator, FieldFeatures& features, const FieldDimensions& field,
                         const FieldFeatureParameters& parameters, const LookAround& look);

}  // namespace reorient
