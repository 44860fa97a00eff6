// SPDX-License-Identifier: MIT
// Simulates camera and legs for tests of the localization: percepts of a robot on the field and odometry, both with
// typical errors.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/pose_filter.h"
#include "perception/field/percepts.h"

namespace reorient {

/// Percepts without an image: all pixels are zero.
inline LinePoint line_point(const Eigen::Vector2d& position, double normal) {
  return {position, normal, Eigen::Vector2f::Zero()};
}
inline GoalPost goal_post(const Eigen::Vector2d& position, bool base_visible = true) {
  return {position, base_visible, Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
}

struct PerceptErrors {
  double distance = 0.04;  ///< of each line point, as a fraction of its distance
  double bearing = 0.015;  ///< rad
  double normal = 8.0 * kPi / 180.0;
  double sway = 0.008;         ///< rad, amplitude of the torso's unmeasured pitch, which affects all distances
  double false_points = 0.05;  ///< fraction of the line points
  double missed_posts = 0.2;   ///< fraction of the goal posts
};

/// Everything that is drawn on the field, seen by a camera with a field of view of 56 degrees.
class SyntheticField {
 public:
  SyntheticField(const FieldDimensions& field, const PerceptErrors& errors, std::uint64_t seed);

  /// The percept of a robot at `truth` that looks `head_yaw` to the left.
  FieldPercept look(const Pose2& truth, double head_yaw, double time);

 private:
  struct DrawnPoint {
    Eigen::Vector2d position;
    double normal = 0.0;
  };

  FieldDimensions field_;
  PerceptErrors errors_;
  Random random_;
  std::vector<DrawnPoint> drawn_;
};

/// Head movement of a scanning robot, rad.
inline double scanning_yaw(double time) { return 1.4 * std::sin(2.0 * kPi * time / 5.0); }

/// The azimuth, rad, at which a camera with this `yaw` looks, on a wall of `radius` m around the center of the field.
double azimuth_from(const Pose2& robot, double yaw, double radius);

/// A robot with a pose filter. Each step is one frame of 1/30 s.
class SyntheticRobot {
 public:
  SyntheticRobot(PoseFilter& filter, const Pose2& where, std::uint64_t seed, const PerceptErrors& errors = {});

  /// The true pose. May be overwritten to move the robot without odometry.
  Pose2 truth;
  double time = 0.0;  ///< s
  /// Radius, m, of the wall of a room that gives the view. Empty: no room.
  std::optional<double> wall_radius;

  /// Stands and moves its head, for one frame.
  void stand(SeenGoal seen_goal = SeenGoal::unknown) { step(Pose2(), seen_goal); }
  void stand_for(double seconds, SeenGoal seen_goal = SeenGoal::unknown);
  /// Walks back and forth between the penalty marks, for one frame.
  void walk(SeenGoal seen_goal = SeenGoal::unknown);

  double position_error() const { return (filter_.belief().pose.position - truth.position).norm(); }  ///< m
  double rotation_error() const;                                                                      ///< rad
  bool believes(const Pose2& pose, double meters = 0.5, double radians = 0.3) const;
  bool believes_truth() const { return believes(truth); }
  bool believes_reflection() const { return believes(reflect(truth)); }

 private:
  void step(const Pose2& motion, SeenGoal seen_goal);

  PoseFilter& filter_;
  SyntheticField field_;
  Random random_;
  Eigen::Vector2d target_{3.2, 0.0};
};

}  // namespace reorient
