// SPDX-License-Identifier: MIT
#include "perception/field/field_features.h"

#include <algorithm>

namespace reorient {
namespace {

/// m. While lines are unknown, a line that leads away from the robot may be mistaken for an upright, low object.
constexpr double kLeastHeight = 0.15, kTallerThanLines = 0.3;

int highest_row_of_ground(const GroundProjection& view) {
  return static_cast<int>(std::clamp(view.highest_horizon(), 0.0, static_cast<double>(view.camera().height)));
}

}  // namespace

FieldFeatures::FieldFeatures(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : carpet_color_(parameters),
      goal_posts_(parameters, field),
      obstacles_(parameters),
      line_points_(parameters, field),
      center_circle_(parameters, field),
      intersections_(parameters, field),
      penalty_marks_(parameters, field),
      ball_(parameters, field),
      circle_radius_(field.center_circle_radius),
      line_width_(field.line_width) {}

void FieldFeatures::find(const ImageView& image, const CameraModel& camera, const Isometry3& robot_from_camera,
                         FieldPercept& percept) {
  percept.clear();
  percept.boundary.assign(CarpetMap::kColumns, static_cast<float>(std::max(image.height, 0)));
  if (image.empty() || image.width < 2) return;
  const bool same_size = camera.width == image.width && camera.height == image.height;
  const auto view =
      GroundProjection::look(same_size ? camera : camera.scaled_to(image.width, image.height), robot_from_camera);
  if (!view) return;

  carpet_color_.observe(image, *view);
  if (!carpet_color_.known()) return;
  carpet_map_.fill(image, carpet_color_, highest_row_of_ground(*view));
  boundary_.find(carpet_map_, view->camera(), percept.boundary);
  const FieldImage seen{image, *view, carpet_color_};
  goal_posts_.find(seen, percept);
  obstacles_.find(carpet_map_, *view, {}, kTallerThanLines, percept);
  line_points_.find(image, *view, carpet_color_, percept);
  percept.center_circle = center_circle_.find(percept.line_points, *view);
  const auto segments = line_segments_.find(percept.line_points, percept.center_circle, circle_radius_);
  const KnownLines lines{segments, percept.center_circle, circle_radius_, line_width_};
  percept.ball = ball_.find(seen, carpet_map_, lines, percept);
  intersections_.find(seen, segments, percept);
  obstacles_.find(carpet_map_, *view, lines, kLeastHeight, percept);
  penalty_marks_.find(seen, line_points_.lone(), percept);
}

void FieldFeatures::set_parameters(const FieldFeatureParameters& parameters) {
  carpet_color_.set_parameters(parameters);
  goal_posts_.set_parameters(parameters);
  obstacles_.set_parameters(parameters);
  line_points_.set_parameters(parameters);
  center_circle_.set_parameters(parameters);
  intersections_.set_parameters(parameters);
  penalty_marks_.set_parameters(parameters);
  ball_.set_parameters(parameters);
}

}  // namespace reorient
