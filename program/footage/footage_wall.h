// SPDX-License-Identifier: MIT
// The virtual wall of footage: set by --wall, or found in the images.
#pragma once

#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "geometry/field_dimensions.h"
#include "robots/footage/footage.h"
#include "robots/robot_body.h"

namespace reorient {

struct FootageWall {
  std::vector<ParameterChange> parameters;  ///< applied before the user's parameters
  std::string line;                         ///< for the user
};

/// `choice`: "auto", "field" or a radius in m. Reads the source if it is "auto". Throws std::runtime_error with one
/// line.
FootageWall footage_wall(FootageSource& source, const std::string& choice, const FieldDimensions& field,
                         const RobotBody& body);

}  // namespace reorient
