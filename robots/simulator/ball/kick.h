// SPDX-License-Identifier: MIT
// A kick: the robot stands still, swings a leg, and hits the ball if it lies within reach of the foot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/pose2.h"
#include "geometry/random.h"
#include "robots/application.h"

namespace reorient {

struct KickParameters {
  double delay = 0.8;
  double recovery = 0.8;
  double reach = 0.28;
  double side = 0.09;
  double foot_speed = 1.2;
  double speed_noise = 0.1;
  double direction_noise = 0.08;
};

template <typename Visit>
void describe(KickParameters& p, Visit&& visit) {
  visit("delay", p.delay, 0.0, 5.0, "s", "time from the start of a kick until the foot is where it hits the ball");
  visit("recovery", p.recovery, 0.0, 5.0, "s", "time after the hit until the robot stands on both feet again");
  visit("reach", p.reach, 0.0, 2.0, "m",
        "largest distance in front of the center of the robot at which a foot hits the center of the ball");
  visit("side", p.side, 0.0, 1.0, "m", "largest distance of the ball to either side of the kicking foot");
  visit("foot_speed", p.foot_speed, 0.1, 10.0, "m/s",
        "speed of the foot at the hit; the masses of leg and ball set the speed of the ball");
  visit("speed_noise", p.speed_noise, 0.0, 1.0, "",
        "standard deviation of the speed of the kicked ball, divided by the speed");
  visit("direction_noise", p.direction_noise, 0.0, 1.0, "rad",
        "standard deviation of the direction of the kicked ball");
}

/// The foot that kicks; nearest: that on whose side the ball lies.
enum class Foot { nearest, left, right };

/// The robot at one moment.
struct KickerState {
  Pose2 pose;                 ///< true pose
  bool is_upright = true;     ///< neither fallen nor lifted
  bool is_lifted = false;     ///< by the operator
  bool is_penalized = false;  ///< by the referee
  double speed = 0.0;         ///< m/s, of the walk
  double size = 1.0;          ///< relative to a NAO
};

class Kick {
 public:
  Kick(const KickParameters& parameters, std::uint64_t seed) : parameters_(parameters), random_(seed, kStream) {}

  /// Starts a kick, also if the last one has not ended. `direction`: rad, relative to the robot, positive to the left.
  void begin(Foot foot, double direction);
  /// Whether the robot must stand for the kick.
  bool is_active() const { return phase_ != Phase::none; }

  struct Progress {
    std::optional<ActionState> state;         ///< what is to be reported now
    std::string reason;                       ///< of a failure
    std::optional<Eigen::Vector2d> velocity;  ///< m/s, of the ball that is hit now
  };
  /// Advances by `time_step` seconds. `ball`: position on the field, m; nothing: there is no ball. `mass`: kg.
  Progress advance(double time_step, const KickerState& kicker, const std::optional<Eigen::Vector2d>& ball,
                   double mass);

 private:
  enum class Phase { none, requested, swing, recovery };
  static constexpr std::uint64_t kStream = 0x1c1c;

  /// The empty text if the foot hits the ball; else why it does not.
  std::string obstacle(const KickerState& kicker, const std::optional<Eigen::Vector2d>& ball) const;
  Eigen::Vector2d hit(const KickerState& kicker, double mass);
  Progress fail(std::string reason);

  KickParameters parameters_;
  Random random_;
  Phase phase_ = Phase::none;
  Foot foot_ = Foot::nearest;
  double direction_ = 0.0;  // rad
  double since_ = 0.0;      // s in this phase
};

}  // namespace reorient
