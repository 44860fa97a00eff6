// SPDX-License-Identifier: MIT
// Azimuths of the wall are multiples of 2^-51 rad, the spacing of numbers near pi. So a rotation by 180 degrees is
// exact, and two of them are the identity.
#pragma once

#include <cmath>

#include "geometry/angle.h"

namespace reorient {

/// The azimuth nearest to an angle, rad in (-pi, pi].
inline double to_azimuth(double angle) {
  constexpr double kSteps = 0x1p51;                                       // a radian
  return std::nearbyint(normalize_angle(angle) * kSteps) / kSteps + 0.0;  // no negative zero
}

/// The opposite azimuth, exactly.
inline double opposite(double azimuth) { return azimuth > 0.0 ? azimuth - kPi : azimuth + kPi; }

}  // namespace reorient
