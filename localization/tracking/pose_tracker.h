// SPDX-License-Identifier: MIT
// Follows one hypothesis of the pose filter exactly, together with the errors of the camera's angles: a camera that
// looks too low and a robot that stands farther back look the same from one view. Localization with an extended Kalman
// filter (Thrun, Burgard, Fox: Probabilistic Robotics, chapter 7.4).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/bytes.h"
#include "geometry/camera_bias.h"
#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "localization/measurement/field_line_map.h"
#include "localization/particles/motion_model.h"
#include "localization/pose_belief.h"
#include "localization/tracking/pose_state.h"
#include "perception/field/percepts.h"

namespace reorient {

struct PoseTrackerParameters {
  bool enabled = true;
  double torso_deviation = from_degrees(3.0);
  double mount_deviation = from_degrees(2.0);
  double gravity_deviation = from_degrees(1.5);
  double drift = 0.0003;
  double sway_deviation = 0.01;
  double sway_time = 0.3;
  double line_deviation = 0.03;
  double pixel_deviation = 0.003;
  double noise_time = 10.0;
  double farthest_line_point = 6.0;
};

template <typename Visit>
void describe(PoseTrackerParameters& p, Visit&& visit) {
  visit("enabled", p.enabled, "whether pose and camera bias are tracked; otherwise the pose is the particles' mean");
  visit("torso_deviation", p.torso_deviation, 0.0, 0.3, "rad",
        "standard deviation of the torso's measured roll and pitch, of robots in general");
  visit("mount_deviation", p.mount_deviation, 0.0, 0.3, "rad", "the same of the mounting of a camera");
  visit("gravity_deviation", p.gravity_deviation, 0.0, 0.3, "rad",
        "the same of the direction of gravity that an accelerometer tells; 0: it is not asked");
  visit("drift", p.drift, 0.0, 0.1, "rad/s^0.5", "how fast these errors change");
  visit("sway_deviation", p.sway_deviation, 0.0, 0.2, "rad",
        "standard deviation of the torso's sway that is not measured");
  visit("sway_time", p.sway_time, 0.01, 10.0, "s", "how long such an error lasts; that of a line's place, too");
  visit("line_deviation", p.line_deviation, 0.001, 1.0, "m", "error of a line point near the robot");
  visit("pixel_deviation", p.pixel_deviation, 0.0001, 0.1, "rad", "error of the direction in which something is seen");
  visit("noise_time", p.noise_time, 0.1, 1e6, "s",
        "time in which it is learned how large these errors of this robot really are");
  visit("farthest_line_point", p.farthest_line_point, 1.0, 60.0, "m", "line points farther away are not used");
}

/// What one camera saw, and the pose of the camera with which it was found (corrected by the bias).
struct CameraPercept {
  const FieldPercept* percept = nullptr;  ///< nothing: no image
  Isometry3 robot_from_camera = Isometry3::Identity();
};

class PoseTracker {
 public:
  PoseTracker(const PoseTrackerParameters& parameters, const FieldDimensions& field);

  void set_parameters(const PoseTrackerParameters& parameters) { parameters_ = parameters; }

  /// Follows the robot's motion, as PoseFilter::predict() does. `time_step`: s.
  void predict(const Pose2& odometry_step, double time_step, const MotionModelParameters& motion);
  /// Begins to follow a hypothesis: `believed` is known to be right, or right but for its reflection.
  void attach(const PoseBelief& believed);
  /// Takes in what was seen. `believed`: by the pose filter, after its update. Lets go where that is elsewhere for
  /// long, or what is seen does not fit.
  void update(const std::array<CameraPercept, 2>& seen, const PoseBelief& believed, double time_step);
  /// The hypothesis may be wrong. What was learned of the angles within the last seconds is forgotten.
  void let_go();
  /// The robot fell or was carried: the same, and its mounts may have moved a little.
  void doubt();
  /// The belief is the reflection of the one before.
  void flip() { state_.flip(); }
  /// What was saved of this body.
  void set_bias(const CameraBias& bias);

  /// What an accelerometer says of the torso's bias. Once of each: its errors stay the same.
  void take_gravity(const TiltBias& torso);

  /// What a search has found, known to about a degree. Call it before attach().
  void take_found(const CameraBias& bias);
  BiasPrior prior() const;

  /// Whether the belief is the tracked one.
  bool is_attached() const { return parameters_.enabled && attached_; }
  /// `believed` with the tracked pose and covariance, where one is tracked.
  PoseBelief belief(const PoseBelief& believed) const;
  CameraBias bias() const;
  /// rad: standard deviation of that about the camera's own horizontal axis, which spoils distances.
  double bias_deviation(const Isometry3& robot_from_camera, std::size_t camera) const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.state_, self.known_.mean, self.known_.covariance, self.attached_, self.attached_for_, self.apart_for_,
            self.fit_, self.noise_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  /// How the line points of a frame fit the lines.
  struct LineFit {
    int fitting = 0;                  ///< on a line, within what the parameters expect
    int odd = 0;                      ///< not
    int measured = 0;                 ///< of those that fit, used
    double normalized_squares = 0.0;  ///< of these: squared residuals by their expected variances
  };

  static bool is_sound(const PoseState& state);
  void complete();
  void take_bias(const CameraBias& bias, double deviation);
  void remember_bias();
  void widen_bias(double time);
  bool is_near(const PoseBelief& believed) const;
  void see_lines(const CameraPercept& seen, std::size_t camera, double weight, LineFit& fit);
  void see_posts(const CameraPercept& seen, std::size_t camera, double weight);

  PoseTrackerParameters parameters_;
  FieldLineMap lines_;
  std::array<Eigen::Vector2d, 4> posts_;
  PoseState state_;
  PoseState known_;  ///< the biases, while it had been attached for long; the pose in it has no meaning
  bool attached_ = false;
  double attached_for_ = 0.0;  ///< s
  double apart_for_ = 0.0;     ///< s, for which its belief has been elsewhere
  double fit_ = 1.0;           ///< share of the line points that lie on lines, over the last second
  double noise_ = 1.0;         ///< what the points' variances really are, as a share of what the parameters say
};

}  // namespace reorient
