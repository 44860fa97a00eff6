// SPDX-License-Identifier: MIT
// What two cameras saw of the field, as if it were one.
#pragma once

#include "perception/field/percepts.h"

namespace reorient {

/// Lines, landmarks and posts of both, in the robot's frame. A post that both see is one: where the lower camera sees
/// its base, it stands there. A landmark that both see is one, too: as the camera sees it that is surer. Obstacles and
/// the boundary belong to an image; they are left out.
void merge(const FieldPercept& upper, const FieldPercept& lower, FieldPercept& merged);

}  // namespace reorient
