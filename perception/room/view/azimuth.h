// SPDX-License-Identifier: MIT
// Azimuths of the wall: multiples of 2^-51 rad, the spacing of numbers near pi, so that half a turn is exact and done
// twice is the identity.
#pragma once

#include <cmath>

#include "geometry/angle.h"

namespace reorient {

/// The azimuth next to an angle, rad in (-pi, pi].
inline double to_azimuth(double angle) {
  constexpr double kSteps = 0x1p51;                                       // a radian
  return std::nearbyint(normalize_angle(angle) * kSteps) / kSteps + 0.0;  // no negative zero
}

/// Half a turn away, exactly.
inline double opposite(double azimuth) { return azimuth > 0.0 ? azimuth - kPi : azimuth + kPi; }

}  // namespace reorient
