// Whether the robot stands, lies or hangs in somebody's hands, from its inertial unit and its feet.
#pragma once

#include <algorithm>
#include <cmath>

#include "robots/robot.h"

namespace reorient {

struct RobotStateParameters {
  double fallen_angle = 0.8;  ///< rad
  double carried_load = 1.5;  ///< kg
  double settle_time = 0.15;  ///< s
};

template <typename Visit>
void describe(RobotStateParameters& p, Visit&& visit) {
  visit("fallen_angle", p.fallen_angle, 0.3, 1.5, "rad", "torso tilt beyond which the robot counts as fallen");
  visit("carried_load", p.carried_load, 0.0, 5.0, "kg", "load on both feet below which the robot counts as carried");
  visit("settle_time", p.settle_time, 0.0, 2.0, "s", "how long a change of load must last to count");
}

/// A lying robot has no load on its feet either: fallen wins over carried.
class RobotState {
 public:
  void update(const BodySample& body, double time_step, const RobotStateParameters& parameters) {
    const double tilt = std::max(std::abs(body.torso.roll), std::abs(body.torso.pitch));
    fallen_ = tilt > parameters.fallen_angle;
    const bool unloaded = !fallen_ && body.foot_load < parameters.carried_load;
    changing_for_ = unloaded == carried_ ? 0.0 : changing_for_ + time_step;
    if (changing_for_ > parameters.settle_time) {
      carried_ = unloaded;
      changing_for_ = 0.0;
    }
  }

  bool fallen() const { return fallen_; }
  bool carried() const { return carried_; }
  /// The soles are on the ground, so the camera's pose can be computed from them.
  bool upright() const { return !fallen_ && !carried_; }

  template <typename Archive>
  void archive(Archive& archive) {
    archive(fallen_, carried_, changing_for_);
  }

 private:
  bool fallen_ = false;
  bool carried_ = false;
  double changing_for_ = 0.0;  ///< s that the load has contradicted carried_
};

}  // namespace reorient
