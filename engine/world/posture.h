// SPDX-License-Identifier: MIT
// How the robot stands, lies or hangs in somebody's hands: from its inertial unit, its feet where they can feel, and
// what it says itself.
#pragma once

#include <cstdint>
#include <string_view>

#include "robots/robot.h"

namespace reorient {

/// A penalty is none: it often comes with a lift, and is what the referee says, not what the body feels.
enum class Posture {
  upright,     ///< on its feet: only now the camera's pose can be computed from them
  falling,     ///< on its way down
  lying,       ///< down
  getting_up,  ///< on its way up, by itself
  lifted       ///< in somebody's hands
};
inline constexpr int kPostures = 5;
constexpr int enum_count(Posture) { return kPostures; }

/// "getting_up": as scripts call it.
std::string_view to_string(Posture posture);

/// Falling, lying or on its way up.
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
  visit("lying_angle", p.lying_angle, 0.3, 1.5, "rad", "torso tilt beyond which the robot lies");
  visit("falling_angle", p.falling_angle, 0.1, 1.5, "rad", "torso tilt beyond which an upright robot falls");
  visit("falling_rate", p.falling_rate, 0.1, 10.0, "rad/s",
        "how fast the torso must tip over to count as falling before that angle is reached");
  visit("lifted_load", p.lifted_load, 0.0, 1.0, "",
        "share of the standing load on both feet below which they carry nothing");
  visit("lifted_time", p.lifted_time, 0.0, 2.0, "s", "how long a change of the feet's load must last to count");
  visit("lifted_height", p.lifted_height, 0.0, 1.0, "m",
        "by how much the torso must have gone up meanwhile: a robot that falls has unloaded feet, too");
  visit("unloaded_time", p.unloaded_time, 0.0, 5.0, "s",
        "unloaded feet for so long are a lift, however the torso moved");
  visit("upright_time", p.upright_time, 0.0, 5.0, "s", "how long a robot that was down must stand to be upright");
  visit("lift_height", p.lift_height, 0.01, 1.0, "m",
        "without foot sensors: by how much the torso must have gone up lately to be lifted");
  visit("lift_memory", p.lift_memory, 0.1, 5.0, "s",
        "without foot sensors: for how long accelerations are summed up to a height");
  visit("still_rate", p.still_rate, 0.01, 2.0, "rad/s",
        "without foot sensors: a lifted robot that turns no faster than this may have been put down");
  visit("still_acceleration", p.still_acceleration, 0.05, 10.0, "m/s^2",
        "without foot sensors: and whose acceleration differs from gravity by no more than this");
  visit("still_time", p.still_time, 0.05, 10.0, "s", "without foot sensors: for how long it must be so still");
}

class PostureEstimator {
 public:
  /// What the engine knows beside the body's own senses.
  struct Hints {
    ReportedPosture reported = ReportedPosture::unknown;
    bool gets_up = false;  ///< it was asked to
  };

  /// One sample of the body; those that are a little out of order, or that hold what is not finite, are
  /// left out.
  void update(const BodySample& sample, std::optional<double> standing_load, const Hints& hints,
              const PostureParameters& parameters);

  Posture posture() const { return posture_; }
  Posture before() const { return before_; }  ///< the posture before this one
  double since() const { return since_; }     ///< s, when this one began

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
  double last_time_ = 0.0;  ///< s, of the sample before
  bool seen_any_ = false;
  double unloaded_for_ = 0.0;  ///< s
  double loaded_for_ = 0.0;    ///< s
  double standing_for_ = 0.0;  ///< s that the torso has been about upright
  double still_for_ = 0.0;     ///< s
  double tipping_ = 0.0;       ///< rad/s, how fast the tilt grows, smoothed over an impact
  double climbed_ = 0.0;       ///< m that the torso has gone up lately
  double climbing_ = 0.0;      ///< m/s
  double bias_ = 0.0;          ///< m/s^2, of the accelerometer along the vertical
};

}  // namespace reorient
