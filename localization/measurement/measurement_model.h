// SPDX-License-Identifier: MIT
// How well poses explain what was seen of the field: line points through the field map, goal posts as landmarks of
// which nobody knows which of the four they are.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/field_dimensions.h"
#include "localization/measurement/field_map.h"
#include "localization/particles/particle_set.h"
#include "perception/field/percepts.h"

namespace reorient {

/// A distance on the ground is judged by the angle below the horizon, so its error grows with its square; the error
/// across the line of sight grows with the distance itself.
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
        "at most this many line points of a frame are used, spread over all of them");
  visit("independent_points", p.independent_points, 1.0, 200.0, "",
        "line points of one frame share their errors: together they weigh at most as much as this many");
  visit("correlation_time", p.correlation_time, 0.0, 5.0, "s",
        "errors last so long (the torso sways): frames that follow each other faster weigh less in proportion");
  visit("position_deviation", p.position_deviation, 0.01, 1.0, "m", "error of a measured position at any distance");
  visit("tilt_deviation", p.tilt_deviation, 0.001, 0.2, "rad", "error of the camera's tilt, which spoils distances");
  visit("bearing_deviation", p.bearing_deviation, 0.001, 0.5, "rad", "error of a bearing");
  visit("camera_height", p.camera_height, 0.1, 4.0, "m", "height above the ground from which distances are judged");
  visit("farthest_line_point", p.farthest_line_point, 1.0, 60.0, "m", "line points farther away are not used");
  visit("farthest_goal_post", p.farthest_goal_post, 1.0, 60.0, "m", "goal posts farther away are not used");
  visit("rough_distance_deviation", p.rough_distance_deviation, 0.05, 5.0, "",
        "error of a post's distance where its base is not in view, as a share of the distance");
  visit("line_point_cost_limit", p.line_point_cost_limit, 0.5, 20.0, "",
        "a line point that fits nowhere costs a pose so much log-likelihood and no more");
  visit("goal_post_cost_limit", p.goal_post_cost_limit, 0.5, 20.0, "",
        "a goal post that fits nowhere costs a pose so much log-likelihood and no more");
}

/// Holds one frame's observations, prepared so that weighing a pose by them is cheap. What is not finite, too near or
/// too far is left out.
class MeasurementModel {
 public:
  MeasurementModel(const FieldDimensions& field, const MeasurementModelParameters& parameters);

  void set_parameters(const MeasurementModelParameters& parameters);
  const MeasurementModelParameters& parameters() const { return parameters_; }
  const FieldMap& map() const { return map_; }

  /// `bias_deviation`: how well the camera's tilt is known beyond what the parameters say, rad.
  void observe(const FieldPercept& percept, double bias_deviation = 0.0);

  std::size_t line_points() const { return line_points_.size(); }
  std::size_t goal_posts() const { return goal_posts_.size(); }
  /// How many terms the cost of a pose is made of: goal posts, and line points as far as they count as independent.
  double terms() const;

  /// Of a position measured at this distance, along and across the line of sight, m^2.
  double variance_along(double distance) const;
  double variance_across(double distance) const;

  /// For each particle -log of the likelihood of what was observed, at least 0, at most what the cost limits allow and
  /// always finite. `costs` becomes as long as `particles`. Equal for a particle and its reflection, bit for bit.
  void costs(const ParticleSet& particles, std::vector<float>& costs) const;

 private:
  struct ObservedLinePoint {
    float x = 0.0f;  ///< m, robot frame
    float y = 0.0f;
    BinaryAngle normal = 0;  ///< robot frame
    float precision = 0.0f;  ///< 1 / (2 variance), of a distance in steps of the map
  };
  struct ObservedGoalPost {
    float x = 0.0f;  ///< m, robot frame
    float y = 0.0f;
    float sight_x = 1.0f;  ///< unit vector from the robot to the post, robot frame
    float sight_y = 0.0f;
    float precision_along = 0.0f;   ///< 1 / (2 variance) along the line of sight, 1/m^2
    float precision_across = 0.0f;  ///< and across it
  };

  void add(const LinePoint& point);
  void add(const GoalPost& post);
  void add_costs(const ObservedLinePoint& point, const ParticleSet& particles, std::vector<float>& costs) const;
  void add_costs(const ObservedGoalPost& post, const ParticleSet& particles, std::vector<float>& costs) const;

  MeasurementModelParameters parameters_;
  double tilt_variance_ = 0.0;  ///< rad^2, of what is observed
  FieldMap map_;
  std::array<Eigen::Vector2d, 4> posts_;
  std::vector<ObservedLinePoint> line_points_;
  std::vector<ObservedGoalPost> goal_posts_;
};

}  // namespace reorient
