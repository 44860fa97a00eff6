// SPDX-License-Identifier: MIT
#include "engine/world/posture.h"

#include <algorithm>
#include <cmath>

#include "geometry/bytes.h"
#include "geometry/gravity.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kLongestStep = 0.2;    // s; after a longer gap the motion in it is unknown
constexpr double kClockReset = 1.0;     // s; a step back by more than this means that the clock was reset
constexpr double kUprightAngle = 0.3;   // rad; largest tilt of a standing robot
constexpr double kImpactTime = 0.05;    // s, duration of an impact in the gyroscopes
constexpr double kBiasTime = 5.0;       // s, time constant of the estimate of the accelerometer's error
constexpr double kLessThanLying = 0.1;  // rad; hysteresis against noise
constexpr double kPushedAngle = 0.1;    // rad; largest tilt of a body that sways on its feet

bool is_finite(const BodySample& sample) {
  return std::isfinite(sample.time + sample.torso.roll + sample.torso.pitch + sample.foot_load) &&
         sample.angular_velocity.allFinite() && sample.acceleration.allFinite();
}

}  // namespace

std::string_view to_string(Posture posture) {
  constexpr std::string_view kNames[kPostures] = {"upright", "falling", "lying", "getting_up", "lifted"};
  return kNames[static_cast<std::size_t>(posture)];
}

void PostureEstimator::check() const {
  for (const double value : {since_, last_time_, unloaded_for_, loaded_for_, standing_for_, still_for_, tipping_,
                             climbed_, climbing_, bias_}) {
    check_bytes(std::isfinite(value), "posture: expected finite values");
  }
}

void PostureEstimator::become(Posture posture, double time) {
  if (posture == posture_) return;
  before_ = posture_;
  posture_ = posture;
  since_ = time;
  still_for_ = 0.0;
  climbed_ = 0.0;
  climbing_ = 0.0;
}

/// Integrates the vertical acceleration twice; old values decay.
void PostureEstimator::follow_height(const BodySample& sample, double step, const PostureParameters& parameters) {
  const double upward = sample.acceleration.dot(up_in_torso(sample.torso)) - kGravity;
  const double forget = 1.0 - std::min(1.0, step / parameters.lift_memory);
  climbing_ = forget * climbing_ + (upward - bias_) * step;
  climbed_ = forget * climbed_ + climbing_ * step;
  if (posture_ == Posture::upright) bias_ += std::min(1.0, step / kBiasTime) * (upward - bias_);
}

void PostureEstimator::update(const BodySample& sample, std::optional<double> standing_load, const Hints& hints,
                              const PostureParameters& parameters) {
  if (!is_finite(sample)) return;
  if (!seen_any_) since_ = sample.time;
  const double elapsed = seen_any_ ? sample.time - last_time_ : 0.0;
  if (elapsed < 0.0 && elapsed > -kClockReset) return;
  const double step = std::clamp(elapsed, 0.0, kLongestStep);
  seen_any_ = true;
  last_time_ = sample.time;

  const double roll = sample.torso.roll;
  const double pitch = sample.torso.pitch;
  const double upright_part = pinned::cos(roll) * pinned::cos(pitch);
  const double tilt = pinned::acos(std::clamp(upright_part, -1.0, 1.0));
  const double lean = pinned::hypot(roll, pitch);
  const double rate =
      lean > 0.0 ? (roll * sample.angular_velocity.x() + pitch * sample.angular_velocity.y()) / lean : 0.0;
  tipping_ += std::min(1.0, step / kImpactTime) * (rate - tipping_);

  const auto count = [step](double& time, bool holds) { time = holds ? time + step : 0.0; };
  const bool unloaded = standing_load && sample.foot_load < parameters.lifted_load * *standing_load;
  count(unloaded_for_, unloaded);
  count(loaded_for_, !unloaded);
  count(standing_for_, tilt < kUprightAngle);
  count(still_for_, sample.angular_velocity.norm() < parameters.still_rate &&
                        std::abs(sample.acceleration.norm() - kGravity) < parameters.still_acceleration);
  follow_height(sample, step, parameters);
  become(next(tilt, standing_load.has_value(), hints, parameters), sample.time);
}

Posture PostureEstimator::next(double tilt, bool feet_feel, const Hints& hints, const PostureParameters& p) const {
  switch (hints.reported) {
    case ReportedPosture::falling:
      return Posture::falling;
    case ReportedPosture::fallen:
      return Posture::lying;
    case ReportedPosture::getting_up:
      return Posture::getting_up;
    case ReportedPosture::upright:
    case ReportedPosture::unknown:
      break;
  }
  const bool knows_itself = hints.reported == ReportedPosture::upright;
  const bool lies = !knows_itself && tilt > p.lying_angle;
  const bool tips_over =
      !knows_itself &&
      (tilt > p.falling_angle || (tipping_ > p.falling_rate && tilt > kPushedAngle && climbed_ < p.lifted_height));
  const bool carries_itself = feet_feel ? loaded_for_ > p.lifted_time : true;
  const bool feet_hang =
      unloaded_for_ > p.unloaded_time || (unloaded_for_ > p.lifted_time && climbed_ > p.lifted_height);
  const bool is_lifted = feet_feel ? feet_hang : climbed_ > p.lift_height;
  switch (posture_) {
    case Posture::upright:
      if (lies) return Posture::lying;
      if (tips_over) return Posture::falling;
      return is_lifted ? Posture::lifted : Posture::upright;
    case Posture::falling:
      if (lies) return Posture::lying;
      if (tips_over) return Posture::falling;
      if (standing_for_ > p.upright_time && carries_itself) return Posture::upright;
      return is_lifted && standing_for_ > p.upright_time ? Posture::lifted : Posture::falling;
    case Posture::lying:
      return tilt > p.lying_angle - kLessThanLying ? Posture::lying : Posture::getting_up;
    case Posture::getting_up:
      if (lies) return Posture::lying;
      // The feet are unloaded while a robot gets up; without a request to get up, the operator has lifted it.
      if (!hints.gets_up && standing_for_ > p.upright_time && is_lifted) return Posture::lifted;
      return standing_for_ > p.upright_time && carries_itself ? Posture::upright : Posture::getting_up;
    case Posture::lifted:
      // A lifted robot can have any attitude; it counts as lying only after it has come to rest.
      if (lies) return still_for_ > p.still_time ? Posture::lying : Posture::lifted;
      if (feet_feel) {
        if (tipping_ > p.falling_rate && tilt > p.falling_angle) return Posture::falling;
        return carries_itself ? Posture::upright : Posture::lifted;
      }
      return still_for_ > p.still_time && standing_for_ > p.still_time ? Posture::upright : Posture::lifted;
  }
  return posture_;
}

}  // namespace reorient
