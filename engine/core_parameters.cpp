// SPDX-License-Identifier: MIT
#include "engine/core_parameters.h"

#include <algorithm>
#include <cmath>

#include "engine/parameters/parameter_registry.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

double half_diagonal(const FieldDimensions& field) { return 0.5 * pinned::hypot(field.length, field.width); }

/// Scales the wall's distance with the field's corners; its tiles have the same elevation angles above the camera.
void fit_wall(double distance, double eye, double usual_eye, WallParameters& wall) {
  const auto raised = [&](double height) {
    return height + (eye - usual_eye) + (height - usual_eye) * (distance - 1.0);
  };
  wall.radius *= distance;
  wall.bottom = std::max(0.0, raised(wall.bottom));
  wall.top = raised(wall.top);
}

}  // namespace

CoreParameters core_parameters_for(const FieldDimensions& field, const RobotBody& body) {
  const FieldDimensions usual_field;
  const RobotBody usual_body;
  const double eye = standing_camera_height(body), usual_eye = standing_camera_height(usual_body);
  const double height = eye / usual_eye;
  CoreParameters parameters;
  fit_wall(half_diagonal(field) / half_diagonal(usual_field), eye, usual_eye, parameters.room.wall);
  ViewParameters& views = parameters.room.views;
  views.reach = std::min(views.reach, body.neck.yaw);
  constexpr double kWidest = 1.57;  // rad, upper limit of the parameter
  views.half_width *= body.upper_camera.field_of_view_horizontal / usual_body.upper_camera.field_of_view_horizontal;
  views.half_width = std::min(views.half_width, kWidest);

  // The range of lines keeps their width in pixels; the range of upright objects keeps the uncertainty of their
  // position on the ground.
  const auto field_of_view = [](const RobotBody& one) { return one.upper_camera.field_of_view_horizontal; };
  const double line = std::sqrt(height * (field.line_width / usual_field.line_width) *
                                (field_of_view(usual_body) / field_of_view(body)));
  FieldFeatureParameters& features = parameters.field_features;
  MeasurementModelParameters& measurement = parameters.localizer.filter.measurement;
  features.line_range *= line;
  measurement.farthest_line_point *= line;
  parameters.localizer.tracker.farthest_line_point *= line;
  features.post_range *= height;
  features.obstacle_range *= height;
  features.obstacle_height *= height;
  measurement.camera_height *= height;
  measurement.farthest_goal_post *= height;
  return parameters;
}

void declare(CoreParameters& parameters, ParameterRegistry& registry) {
  registry.bind("posture", parameters.posture);
  registry.bind("field_features", parameters.field_features);
  registry.bind("pose_filter", parameters.localizer.filter);
  registry.bind("motion_model", parameters.localizer.filter.motion);
  registry.bind("measurement_model", parameters.localizer.filter.measurement);
  registry.bind("goal_injection", parameters.localizer.filter.injection);
  registry.bind("pose_tracker", parameters.localizer.tracker);
  registry.bind("pose_search", parameters.localizer.search);
  registry.bind("pose_clusters", parameters.localizer.filter.clusters);
  for_each_part(parameters.room, [&](const char* prefix, auto& part) { registry.bind(prefix, part); });
  registry.bind("room_status", parameters.room_status);
  registry.bind("goal_view", parameters.goal_view);
  registry.bind("seen_view", parameters.seen_view);
  registry.bind("repeated_pose", parameters.repeated_pose);
  registry.bind("external_belief", parameters.external_belief);
  registry.bind("external_percepts", parameters.external_percepts);
  registry.bind("arbiter", parameters.arbiter);
}

}  // namespace reorient
