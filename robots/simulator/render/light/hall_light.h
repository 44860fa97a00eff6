// SPDX-License-Identifier: MIT
// Changes the light of the hall: exposure and white balance, daylight from one side, lamps that are off in one half,
// other things on the walls. Until change() is called, the pictures stay the same.
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "geometry/random.h"
#include "robots/simulator/render/light/illumination.h"
#include "robots/simulator/render/light/wall_patches.h"

namespace reorient {

struct HallLightParameters {
  double exposure_spread = 0.0;
  double white_balance_spread = 0.0;
  double white_balance_drift = 0.0;
  double white_balance_time = 20.0;
  double daylight = 0.0;
  double daylight_wander = 0.0;
  double daylight_period = 180.0;
  double lamps_off = 0.0;
  double lamps_off_light = 0.35;
  double wall_changed = 0.0;
  double wall_reach = 3.5;
  double people_exchanged = 0.0;
  double people_turnover = 0.0;
};

template <typename Visit>
void describe(HallLightParameters& p, Visit&& visit) {
  visit("exposure_spread", p.exposure_spread, 0.0, 2.0, "",
        "largest change of the light relative to the exposure, up or down, as natural logarithm");
  visit("white_balance_spread", p.white_balance_spread, 0.0, 1.0, "",
        "largest step of the white balance, up or down, as natural logarithms of red and of blue");
  visit("white_balance_drift", p.white_balance_drift, 0.0, 0.5, "",
        "standard deviation of the drift of the white balance, as natural logarithms of red and of blue");
  visit("white_balance_time", p.white_balance_time, 0.5, 600.0, "s", "time constant of the drift of the white balance");
  visit("daylight", p.daylight, 0.0, 3.0, "",
        "largest gain of light by daylight over a quarter of the room, in powers of two (stops)");
  visit("daylight_wander", p.daylight_wander, 0.0, 3.1416, "rad",
        "largest change of the direction of the daylight, to either side");
  visit("daylight_period", p.daylight_period, 10.0, 3600.0, "s",
        "period with which the direction of the daylight moves to and fro");
  visit("lamps_off", p.lamps_off, 0.0, 1.0, "", "probability that the lamps of one half of the room are off");
  visit("lamps_off_light", p.lamps_off_light, 0.0, 1.0, "",
        "fraction of the light that remains where the lamps are off");
  visit("wall_changed", p.wall_changed, 0.0, 0.5, "",
        "fraction of the wall that new things cover (banners, doors, curtains) after a change of the light");
  visit("wall_reach", p.wall_reach, 2.5, 10.0, "m", "height up to which new things cover the wall");
  visit("people_exchanged", p.people_exchanged, 0.0, 1.0, "",
        "fraction of the spectators that other people replace at a change of the light");
  visit("people_turnover", p.people_turnover, 0.0, 10.0, "1/min",
        "rate at which other people replace each spectator after a change of the light");
}

class HallLight {
 public:
  HallLight(const HallLightParameters& parameters, double room_height, std::uint64_t seed);  ///< height in m

  /// Draws a new light at random. From then on, its daylight wanders and its white balance drifts.
  void change();
  /// Draws the new things on the walls of a room.
  WallPatches draw_patches(const Room& room) {
    return {parameters_.wall_changed, parameters_.wall_reach, room, random_};
  }
  void advance(double time_step);  ///< s

  bool changed() const { return changed_; }
  const Illumination& illumination() const { return illumination_; }
  /// Factors on a picture's red, green and blue: exposure and white balance together.
  Eigen::Array3d gains() const;

 private:
  void turn_daylight();

  HallLightParameters parameters_;
  Random random_;
  bool changed_ = false;
  double time_ = 0.0;  // s since the change
  double exposure_ = 0.0;
  double red_ = 0.0, blue_ = 0.0;              // natural logarithms at the change
  double red_drift_ = 0.0, blue_drift_ = 0.0;  // natural logarithms, drift since the change
  double daylight_azimuth_ = 0.0;              // rad, at the change
  Illumination illumination_;
};

}  // namespace reorient
