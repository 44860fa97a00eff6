// SPDX-License-Identifier: MIT
// Factor between the present and the usual light at each point of the room.
#pragma once

#include <span>

#include <Eigen/Core>

namespace reorient {

/// Positions in meters and directions in the field's plane. By default the light is as usual everywhere.
///
/// Daylight is a smooth gain of 2^(stops cos^2 a) at an angle of a < 90 degrees from its direction, seen from the
/// center of the field: the gain is at least half of the stops over a quarter of the room. Lamps fill the ceiling
/// evenly. If those of one half are off, a point gets the light of an infinite half plane of lamps,
/// (1 + s / sqrt(s^2 + h^2)) / 2 of the whole, at a distance s from the border of the dark half and h below the lamps,
/// and the light that does not come from lamps.
struct Illumination {
  Eigen::Vector2f daylight = Eigen::Vector2f::UnitX();     ///< direction from the center to the daylight
  float daylight_stops = 0.0f;                             ///< powers of two, largest gain
  Eigen::Vector2f toward_dark = Eigen::Vector2f::UnitX();  ///< from the center into the half whose lamps are off
  float fraction_off = 0.0f;                               ///< fraction of light that comes from lamps; 0: all are on
  float lamp_height = 5.0f;                                ///< m
  /// Daylight and dark lamps are on both sides, for a symmetric room: a point has the light of its mirrored point.
  bool repeated = false;

  bool as_usual() const { return daylight_stops == 0.0f && fraction_off == 0.0f; }

  /// The factor on the light at points of the ground or above them, m. All spans have the same length.
  void gains(std::span<const float> x, std::span<const float> y, std::span<float> gains) const;
  float gain(float x, float y) const;
};

}  // namespace reorient
