// SPDX-License-Identifier: MIT
#include "robots/simulator/render/light/hall_light.h"

#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"

namespace reorient {

HallLight::HallLight(const HallLightParameters& parameters, double room_height, std::uint64_t seed)
    : parameters_(parameters), random_(seed, 0x119473) {
  illumination_.lamp_height = static_cast<float>(room_height);
}

void HallLight::change() {
  const HallLightParameters& p = parameters_;
  const auto within = [&](double spread) { return random_.uniform(-spread, spread); };
  changed_ = true;
  time_ = 0.0;
  red_drift_ = blue_drift_ = 0.0;
  exposure_ = within(p.exposure_spread);
  red_ = within(p.white_balance_spread);
  blue_ = within(p.white_balance_spread);
  illumination_.daylight_stops = static_cast<float>(random_.uniform(0.0, p.daylight));
  daylight_azimuth_ = random_.uniform(-kPi, kPi);
  turn_daylight();
  // Lamps hang in rows along the walls, and a switch turns off whole rows. So the dark half faces one of the walls.
  illumination_.fraction_off = static_cast<float>(random_.uniform() < p.lamps_off ? 1.0 - p.lamps_off_light : 0.0);
  illumination_.toward_dark = unit_vector(0.5 * kPi * static_cast<double>(random_.below(4))).cast<float>();
}

void HallLight::advance(double time_step) {
  if (!changed_) return;
  time_ += time_step;
  turn_daylight();
  // An Ornstein-Uhlenbeck process, in steps of any length.
  const double kept = pinned::exp(-time_step / parameters_.white_balance_time);
  const double fresh = parameters_.white_balance_drift * std::sqrt(1.0 - kept * kept);
  red_drift_ = kept * red_drift_ + fresh * random_.normal();
  blue_drift_ = kept * blue_drift_ + fresh * random_.normal();
}

void HallLight::turn_daylight() {
  const double phase = 2.0 * kPi * time_ / parameters_.daylight_period;
  illumination_.daylight =
      unit_vector(daylight_azimuth_ + parameters_.daylight_wander * pinned::sin(phase)).cast<float>();
}

Eigen::Array3d HallLight::gains() const {
  if (!changed_) return Eigen::Array3d::Ones();
  return {pinned::exp(exposure_ + red_ + red_drift_), pinned::exp(exposure_),
          pinned::exp(exposure_ + blue_ + blue_drift_)};
}

}  // namespace reorient
