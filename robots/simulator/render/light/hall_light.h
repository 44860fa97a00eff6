// SPDX-License-Identifier: MIT
// The light of the hall when somebody has changed it: another exposure and white balance, daylight from one side, half
// of the lamps off, other things on the walls. Until then nothing here touches a picture.
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
        "the changed light against the exposure: natural logarithm, at most this much up or down");
  visit("white_balance_spread", p.white_balance_spread, 0.0, 1.0, "",
        "step of the white balance: natural logarithms of red and of blue, at most this much up or down");
  visit("white_balance_drift", p.white_balance_drift, 0.0, 0.5, "",
        "drift of the white balance: standard deviation of both logarithms");
  visit("white_balance_time", p.white_balance_time, 0.5, 600.0, "s", "time constant of that drift");
  visit("daylight", p.daylight, 0.0, 3.0, "",
        "powers of two of light, at most, that daylight adds over a quarter of the room");
  visit("daylight_wander", p.daylight_wander, 0.0, 3.1416, "rad", "how far the daylight wanders to either side");
  visit("daylight_period", p.daylight_period, 10.0, 3600.0, "s", "how long it takes to wander to and fro");
  visit("lamps_off", p.lamps_off, 0.0, 1.0, "", "probability that the lamps of one half of the room are off");
  visit("lamps_off_light", p.lamps_off_light, 0.0, 1.0, "", "share of light that is left where no lamp shines");
  visit("wall_changed", p.wall_changed, 0.0, 0.5, "", "share of the wall that carries something else");
  visit("wall_reach", p.wall_reach, 2.5, 10.0, "m", "how high the wall is changed");
  visit("people_exchanged", p.people_exchanged, 0.0, 1.0, "", "share of the spectators for whom others come");
  visit("people_turnover", p.people_turnover, 0.0, 10.0, "1/min", "how often each spectator's place changes hands");
}

class HallLight {
 public:
  HallLight(const HallLightParameters& parameters, double room_height, std::uint64_t seed);  ///< height in m

  /// Draws another light, which holds from now on; its daylight wanders and its white balance drifts.
  void change();
  /// What is new on the walls of a room since then.
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
  double red_ = 0.0, blue_ = 0.0;              // natural logarithms, as the light came
  double red_drift_ = 0.0, blue_drift_ = 0.0;  // the same, since then
  double daylight_azimuth_ = 0.0;              // rad, as the light came
  Illumination illumination_;
};

}  // namespace reorient
