// SPDX-License-Identifier: MIT
#include "localization/tracking/gravity_bias.h"

#include <cmath>

#include "geometry/gravity.h"
#include "geometry/pinned_math.h"

namespace reorient {

std::optional<TiltBias> GravityBias::add_sample(const Eigen::Vector3d& acceleration, const TorsoAttitude& measured,
                                                double time) {
  constexpr double kMostOff = 4.0;    // m/s^2
  constexpr double kFeltFor = 3.0;    // s
  constexpr int kFewest = 60;         // samples
  constexpr double kMostTilt = 0.35;  // rad; a robot that is tilted more does not stand
  constexpr double kNothing = 1e-12;  // m/s^2; a robot without an accelerometer sends exactly vertical gravity
  if (is_reported_) return std::nullopt;
  const bool is_believable = std::abs(acceleration.norm() - kGravity) <= kMostOff &&
                             std::abs(measured.roll) <= kMostTilt && std::abs(measured.pitch) <= kMostTilt;
  if (!is_believable || acceleration.head<2>().norm() < kNothing || !std::isfinite(time)) return std::nullopt;
  if (samples_ == 0 || time < began_) {
    interrupt();
    began_ = time;
  }
  const double roll = pinned::atan2(acceleration.y(), acceleration.z());
  const double pitch = pinned::atan2(-acceleration.x(), pinned::hypot(acceleration.y(), acceleration.z()));
  sum_.roll += roll - measured.roll;
  sum_.pitch += pitch - measured.pitch;
  ++samples_;
  if (samples_ < kFewest || time - began_ < kFeltFor) return std::nullopt;
  const TiltBias mean{sum_.roll / samples_, sum_.pitch / samples_};
  is_reported_ = std::abs(mean.roll) <= kMostTilt && std::abs(mean.pitch) <= kMostTilt;
  interrupt();
  return is_reported_ ? std::optional(mean) : std::nullopt;
}

void GravityBias::interrupt() {
  sum_ = {};
  samples_ = 0;
}

}  // namespace reorient
