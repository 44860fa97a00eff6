// SPDX-License-Identifier: MIT
// Parts of the ground that are hidden by objects on it.
#pragma once

#include <Eigen/Core>

#include "perception/field/percepts.h"

namespace reorient {

/// Whether an obstacle, a goal post or the ball of the percept is in front of the ground at a pixel, or close to it.
bool hides(const FieldPercept& percept, const Eigen::Vector2d& pixel);

}  // namespace reorient
