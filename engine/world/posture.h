// SPDX-License-Identifier: MIT
// Estimates the posture of the robot from its inertial unit, its foot sensors (if any), and the posture that it
// reports.
#pragma once

#include <cstdint>
#include <string_view>

#include "robots/robot.h"

namespace reorient {

/// A penalty is not a posture: the referee reports it, although it often comes with a lift.
enum class Posture {
  upright,     ///< on its feet: only then the camera's pose can be computed from them
  falling,     ///< tipping over
  lying,       ///< on the ground
  getting_up,  ///< moving to its feet by itself
  lifted       ///< in the operator's hands
};
inline constexpr int kPostures = 5;
constexpr int enum_count(Posture) { return kPostures; }

/// "getting_up": the name in scripts.
std::string_view to_string(Posture posture);

/// Falling, lying or getting up.
constexpr bool is_down(Posture posture) { return posture != Posture::upright && posture != Posture::lifted; }

struct PostureParameters {
  double lying_angle = 0.8;
  double falling_angle = 0.45;
  double falling_rate = 0.65;
  double lifted_load = 0.28;
  double lifted_time = 0.2;
  double lifted_height = 0.03;
  double unloaded_time = 0.6;
  double upright_time = 0.3;
  double lift_height = 0.1;
  double lift_memory = 0.7;
  double still_rate = 0.12;
  double still_acceleration = 0.8;
  double still_time = 0.5;
};

template <typename Visit>
void describe(PostureParameters& p, Visit&& visit) {
  visit("lying_angle", p.lying_angle, 0.3, 1.5, "rad", "torso tilt above which the robot counts as lying");
  visit("falling_angle", p.falling_angle, 0.1, 1.5, "rad", "torso tilt above which an upright robot counts as falling");
  visit("falling_rate", p.falling_rate, 0.1, 10.0, "rad/s",
        "smallest tipping rate of the torso at which the robot counts as falling below falling_angle");
  visit("lifted_load", p.lifted_load, 0.0, 1.0, "",
        "fraction of the standing load on both feet below which they count as unloaded");
  visit("lifted_time", p.lifted_time, 0.0, 2.0, "s", "shortest time for which a change of the feet's load must last");
  visit("lifted_height", p.lifted_height, 0.0, 1.0, "m",
        "smallest rise of the torso with unloaded feet that counts as a lift; excludes falls");
  visit("unloaded_time", p.unloaded_time, 0.0, 5.0, "s",
        "time with unloaded feet that counts as a lift without a rise of the torso");
  visit("upright_time", p.upright_time, 0.0, 5.0, "s",
        "time for which a robot that was down must stand to count as upright");
  visit("lift_height", p.lift_height, 0.01, 1.0, "m",
        "without foot sensors: smallest recent rise of the torso that counts as a lift");
  visit("lift_memory", p.lift_memory, 0.1, 5.0, "s",
        "without foot sensors: time constant of the integration of accelerations to a height");
  visit("still_rate", p.still_rate, 0.01, 2.0, "rad/s",
        "without foot sensors: largest rotation rate at which a lifted robot may count as placed on the ground");
  visit("still_acceleration", p.still_acceleration, 0.05, 10.0, "m/s^2",
        "without foot sensors: largest difference of acceleration and gravity at which a lifted robot may count as "
        "placed");
  visit(
      "still_time", p.still_time, 0.05, 10.0, "s",
      "without foot sensors: time below still_rate and still_acceleration after which a lifted robot counts as placed");
}

class PostureEstimator {
 public:
  /// Knowledge of the engine in addition to the body's sensors.
  struct Hints {
    ReportedPosture reported = ReportedPosture::unknown;
    bool gets_up = false;  ///< a behavior requested it
  };

  /// Adds a sample of the body; ignores samples that are slightly out of order or have values that are not
  /// finite.
  void update(const BodySample& sample, std::optional<double> standing_load, const Hints& hints,
              const PostureParameters& parameters);

  Posture posture() const { return posture_; }
  Posture before() const { return before_; }  ///< previous posture
  double since() const { return since_; }     ///< s, start of the posture

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.posture_, self.before_, self.since_, self.last_time_, self.seen_any_, self.unloaded_for_,
            self.loaded_for_, self.standing_for_, self.still_for_, self.tipping_, self.climbed_, self.climbing_,
            self.bias_);
    if constexpr (Archive::kReads) self.check();
  }

 private:
  void check() const;
  void become(Posture posture, double time);
  void follow_height(const BodySample& sample, double step, const PostureParameters& parameters);
  Posture next(double tilt, bool feet_feel, const Hints& hints, const PostureParameters& parameters) const;

  Posture posture_ = Posture::upright;
  Posture before_ = Posture::upright;
  double since_ = 0.0;
  double last_time_ = 0.0;  ///< s, of the previous sample
  bool seen_any_ = false;
  double unloaded_for_ = 0.0;  ///< s
  double loaded_for_ = 0.0;    ///< s
  double standing_for_ = 0.0;  ///< s for which the torso has been nearly upright
  double still_for_ = 0.0;     ///< s
  double tipping_ = 0.0;       ///< rad/s, how fast the tilt grows, smoothed over an impact
  double climbed_ = 0.0;       ///< m, recent rise of the torso
  double climbing_ = 0.0;      ///< m/s
  double bias_ = 0.0;          ///< m/s^2, of the accelerometer along the vertical
};

}  // namespace reorient
