// SPDX-License-Identifier: MIT
// How well poses explain the percepts of the field: line points by the field map, goal posts as landmarks of which it
// is unknown which of the four they are.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "geometry/field_dimensions.h"
#include "localization/measurement/field_map.h"
#include "localization/particles/particle_set.h"
#include "perception/field/percepts.h"

namespace reorient {

/// A distance on the ground is measured by the angle below the horizon, so its error grows with its square. The error
/// across the line of sight grows linearly with the distance.
struct MeasurementModelParameters {
  int line_points = 40;
  double independent_points = 8.0;
  double correlation_time = 0.3;
  double position_deviation = 0.05;
  double tilt_deviation = 0.01;
  double bearing_deviation = 0.03;
  double camera_height = 0.5;
  double farthest_line_point = 6.0;
  double farthest_goal_post = 10.0;
  double rough_distance_deviation = 0.5;
  double line_point_cost_limit = 3.0;
  double goal_post_cost_limit = 4.0;
};

template <typename Visit>
void describe(MeasurementModelParameters& p, Visit&& visit) {
  visit("line_points", p.line_points, 1, 200, "",
        "largest number of line points used of a frame, spread evenly over all of them");
  visit("independent_points", p.independent_points, 1.0, 200.0, "",
        "largest weight of all line points of a frame, which share errors, as a number of independent points");
  visit("correlation_time", p.correlation_time, 0.0, 5.0, "s",
        "time for which errors last, since the torso sways; frames at shorter intervals weigh proportionally less");
  visit("position_deviation", p.position_deviation, 0.01, 1.0, "m",
        "standard deviation of a measured position at any distance");
  visit("tilt_deviation", p.tilt_deviation, 0.001, 0.2, "rad",
        "standard deviation of the camera's tilt, which affects distances");
  visit("bearing_deviation", p.bearing_deviation, 0.001, 0.5, "rad", "standard deviation of a bearing");
  visit("camera_height", p.camera_height, 0.1, 4.0, "m",
        "assumed height of the camera, from which errors of distances follow");
  visit("farthest_line_point", p.farthest_line_point, 1.0, 60.0, "m", "largest distance at which line points are used");
  visit("farthest_goal_post", p.farthest_goal_post, 1.0, 60.0, "m", "largest distance at which goal posts are used");
  visit("rough_distance_deviation", p.rough_distance_deviation, 0.05, 5.0, "",
        "standard deviation of the distance of a post without its base in view, as a fraction of it");
  visit("line_point_cost_limit", p.line_point_cost_limit, 0.5, 20.0, "",
        "largest log-likelihood that a line point can cost a pose");
  visit("goal_post_cost_limit", p.goal_post_cost_limit, 0.5, 20.0, "",
        "largest log-likelihood that a goal post can cost a pose");
}

/// How well each feature of a percept fits the field at one pose. 0: exactly, 1: it costs the pose as much as the
/// measurement model permits, so it is rejected; kIgnored: the feature is too near, too far or not finite.
struct FeatureFits {
  static constexpr float kIgnored = -1.0f;

  std::vector<float> line_points;  ///< as FieldPercept::line_points
  std::vector<float> goal_posts;   ///< as FieldPercept::goal_posts

  void clear() {
    line_points.clear();
    goal_posts.clear();
  }
  /// Reserves memory for as many features as `percept` has memory for.
  void reserve(const FieldPercept& percept) {
    line_points.reserve(percept.line_points.capacity());
    goal_posts.reserve(percept.goal_posts.capacity());
  }
};
template <typename Visit, ConstOr<FeatureFits> T>
void fields(Visit&& visit, T& fits) {
  visit(fits.line_points, fits.goal_posts);
}

/// The observations of one frame, prepared so that the cost of a pose is fast to compute. Ignores those that are not
/// finite, too near or too far.
class MeasurementModel {
 public:
  MeasurementModel(const FieldDimensions& field, const MeasurementModelParameters& parameters);

  void set_parameters(const MeasurementModelParameters& parameters);
  const MeasurementModelParameters& parameters() const { return parameters_; }
  const FieldMap& map() const { return map_; }

  /// `bias_deviation`: standard deviation of the camera's tilt in addition to the parameters', rad.
  void observe(const FieldPercept& percept, double bias_deviation = 0.0);

  std::size_t line_points() const { return line_points_.size(); }
  std::size_t goal_posts() const { return goal_posts_.size(); }
  /// Number of independent terms of a pose's cost: goal posts, and line points up to `independent_points`.
  double terms() const;

  // Variances of a position measured at this distance, along and across the line of sight, m^2.
  double variance_along(double distance) const;
  double variance_across(double distance) const;

  /// For each particle, -log of the likelihood of the observations: finite, non-negative, bounded by the cost limits.
  /// Resizes `costs` to the number of particles. Exactly equal for a particle and its reflection.
  void costs(const ParticleSet& particles, std::vector<float>& costs) const;

  /// The cost of each feature of `percept` for one pose, as a fraction of its limit, with the variances of the present
  /// observations. `pose`: a set of one particle. Uses all line points, while costs() uses some of them.
  void fits(const FieldPercept& percept, const ParticleSet& pose, FeatureFits& fits) const;

 private:
  struct ObservedLinePoint {
    float x = 0.0f;  ///< m, robot frame
    float y = 0.0f;
    BinaryAngle normal = 0;  ///< robot frame
    float precision = 0.0f;  ///< 1 / (2 variance) of a distance in steps of the map
  };
  struct ObservedGoalPost {
    float x = 0.0f;  ///< m, robot frame
    float y = 0.0f;
    float sight_x = 1.0f;  ///< unit vector from the robot to the post, robot frame
    float sight_y = 0.0f;
    float precision_along = 0.0f;   ///< 1 / (2 variance) along the line of sight, 1/m^2
    float precision_across = 0.0f;  ///< the same across it, 1/m^2
  };

  ObservedLinePoint observed(const LinePoint& point) const;
  ObservedGoalPost observed(const GoalPost& post) const;
  bool is_usable(const LinePoint& point) const;
  bool is_usable(const GoalPost& post) const;
  void add_costs(const ObservedLinePoint& point, const ParticleSet& particles, std::span<float> costs) const;
  void add_costs(const ObservedGoalPost& post, const ParticleSet& particles, std::span<float> costs) const;

  MeasurementModelParameters parameters_;
  double tilt_variance_ = 0.0;  ///< rad^2, of the present observations
  FieldMap map_;
  std::array<Eigen::Vector2d, 4> posts_;
  std::vector<ObservedLinePoint> line_points_;
  std::vector<ObservedGoalPost> goal_posts_;
};

}  // namespace reorient
