// SPDX-License-Identifier: MIT
// Merges the percepts of two cameras into one.
#pragma once

#include "perception/field/percepts.h"

namespace reorient {

/// Lines, landmarks and posts of both, in the robot's frame. A post in both images counts once, with the lower camera's
/// position if that shows its base. A landmark in both images counts once, with the smaller covariance. Obstacles and
/// the boundary belong to a single image and are left out.
void merge(const FieldPercept& upper, const FieldPercept& lower, FieldPercept& merged);

}  // namespace reorient
