// SPDX-License-Identifier: MIT
// Tracks one hypothesis of the pose filter precisely, together with the errors of the camera's angles, because in one
// view a camera that looks too low and a robot that is farther back look the same. Localization with an extended Kalman
// filter (Thrun, Burgard, Fox: Probabilistic Robotics, chapter 7.4).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/bytes.h"
#include "geometry/camera.h"
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
  visit("enabled", p.enabled,
        "whether pose and camera bias are tracked; otherwise the pose is the mean of the particles");
  visit("torso_deviation", p.torso_deviation, 0.0, 0.3, "rad",
        "standard deviation of the error of the torso's measured roll and pitch, before anything is learned");
  visit("mount_deviation", p.mount_deviation, 0.0, 0.3, "rad",
        "standard deviation of the error of a camera's mounting in roll and pitch, before anything is learned");
  visit("gravity_deviation", p.gravity_deviation, 0.0, 0.3, "rad",
        "standard deviation of the direction of gravity from the accelerometer; 0 disables its use");
  visit("drift", p.drift, 0.0, 0.1, "rad/s^0.5", "rate at which the errors of torso and mountings change");
  visit("sway_deviation", p.sway_deviation, 0.0, 0.2, "rad", "standard deviation of the torso's unmeasured sway");
  visit("sway_time", p.sway_time, 0.01, 10.0, "s", "time constant of the sway and of the errors of line points");
  visit("line_deviation", p.line_deviation, 0.001, 1.0, "m", "standard deviation of a line point near the robot");
  visit("pixel_deviation", p.pixel_deviation, 0.0001, 0.1, "rad",
        "standard deviation of the direction of a line of sight");
  visit("noise_time", p.noise_time, 0.1, 1e6, "s", "time constant with which the true size of these errors is learned");
  visit("farthest_line_point", p.farthest_line_point, 1.0, 60.0, "m", "largest distance at which line points are used");
}

/// The percept of one camera, and the pose of the camera with which it was computed (corrected by the bias).
struct CameraPercept {
  const FieldPercept* percept = nullptr;  ///< null: no image
  Isometry3 robot_from_camera = Isometry3::Identity();
  const CameraModel* camera = nullptr;  ///< null: unknown
};

class PoseTracker {
 public:
  PoseTracker(const PoseTrackerParameters& parameters, const FieldDimensions& field);

  void set_parameters(const PoseTrackerParameters& parameters) { parameters_ = parameters; }

  /// Follows the odometry, as PoseFilter::predict() does. `time_step`: s.
  void predict(const Pose2& odometry_step, double time_step, const MotionModelParameters& motion);
  /// Starts to track a hypothesis: either `believed` or its reflection is known to be right.
  void attach(const PoseBelief& believed);
  /// Updates the state with the percepts. `believed`: of the pose filter after its update. Calls detach() if this
  /// belief differs for long, or if the percepts do not fit.
  void update(const std::array<CameraPercept, 2>& seen, const PoseBelief& believed, double time_step);
  /// Stops tracking, because the hypothesis may be wrong. Restores the biases of some seconds ago.
  void detach();
  /// The robot fell or was lifted: the same, and its mounts may have moved a little.
  void doubt();
  /// Reflects the tracked pose.
  void flip() { state_.flip(); }
  /// Sets the bias that was saved for this body.
  void set_bias(const CameraBias& bias);

  /// Uses the accelerometer's estimate of the torso's bias. Call it once: the accelerometer's error is constant.
  void take_gravity(const TiltBias& torso);

  /// Sets the bias that a search has found, with an error of about a degree. Call it before attach().
  void take_found(const CameraBias& bias);
  BiasPrior prior() const;

  /// Whether a pose is tracked.
  bool is_attached() const { return parameters_.enabled && attached_; }
  /// `believed`, with the tracked pose and covariance if one is tracked.
  PoseBelief belief(const PoseBelief& believed) const;
  CameraBias bias() const;
  /// rad: standard deviation of the bias about the camera's horizontal axis, which affects distances.
  double bias_deviation(const Isometry3& robot_from_camera, std::size_t camera) const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.state_, self.known_.mean, self.known_.covariance, self.attached_, self.attached_for_, self.apart_for_,
            self.fit_, self.noise_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  /// How well the line points of a frame fit the lines.
  struct LineFit {
    int fitting = 0;                  ///< on a line, within the errors that the parameters expect
    int odd = 0;                      ///< not on a line
    int measured = 0;                 ///< used, of those that fit
    double normalized_squares = 0.0;  ///< of the used ones: squared residuals over expected variances
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
  PoseState known_;  ///< the confirmed biases, after tracking for long enough; its pose is unused
  bool attached_ = false;
  double attached_for_ = 0.0;  ///< s
  double apart_for_ = 0.0;     ///< s, for which the pose filter's belief has differed
  double fit_ = 1.0;           ///< fraction of the line points on lines, over the last second
  double noise_ = 1.0;         ///< true variance of the points, relative to the parameters'
};

}  // namespace reorient
