// SPDX-License-Identifier: MIT
// How much more or less light than usual falls on each place of the room.
#pragma once

#include <span>

#include <Eigen/Core>

namespace reorient {

/// Metres and directions in the field's plane. As it is made, the light is as usual everywhere.
///
/// Daylight is a smooth gain of 2^(stops cos^2 a) at an angle of a < 90 degrees from its direction, seen from the
/// middle of the field: half of the stops reach over a quarter of the room. Lamps fill the ceiling evenly; where those
/// of one half are off, a place gets the light of an endless half plane, (1 + s / sqrt(s^2 + h^2)) / 2 of the whole at
/// a distance s from the border of the dark half and h below the lamps, and besides what is left without any lamp.
struct Illumination {
  Eigen::Vector2f daylight = Eigen::Vector2f::UnitX();     ///< from the middle towards it
  float daylight_stops = 0.0f;                             ///< powers of two, at most
  Eigen::Vector2f toward_dark = Eigen::Vector2f::UnitX();  ///< from the middle into the half whose lamps are off
  float share_off = 0.0f;                                  ///< of the light that lamps give; 0: all of them are on
  float lamp_height = 5.0f;                                ///< m
  /// Both come from both sides, as in a room that looks the same after half a turn: a place is lit as its reflection
  /// is.
  bool repeated = false;

  bool as_usual() const { return daylight_stops == 0.0f && share_off == 0.0f; }

  /// The factor on the light that falls on places of the ground or above them, m. All of one length.
  void gains(std::span<const float> x, std::span<const float> y, std::span<float> gains) const;
  float gain(float x, float y) const;
};

}  // namespace reorient
