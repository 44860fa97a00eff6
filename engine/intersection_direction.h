// SPDX-License-Identifier: MIT
// The direction of an intersection from the lines around it, for detectors that find only its position and type.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "geometry/field_landmarks.h"
#include "perception/field/percepts.h"

namespace reorient {

/// As in FieldIntersection, rad, robot frame. Empty if the lines in view do not decide it.
std::optional<double> direction_from_lines(IntersectionKind kind, const Eigen::Vector2d& position,
                                           const std::array<FieldPercept, 2>& percepts);

}  // namespace reorient
