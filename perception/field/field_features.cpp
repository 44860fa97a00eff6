#include "perception/field/field_features.h"

#include <algorithm>

namespace reorient {
namespace {

int highest_row_of_ground(const GroundProjection& view) {
  return static_cast<int>(std::clamp(view.highest_horizon(), 0.0, static_cast<double>(view.camera().height)));
}

}  // namespace

FieldFeatures::FieldFeatures(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : carpet_color_(parameters),
      goal_posts_(parameters, field),
      obstacles_(parameters),
      line_points_(parameters, field) {}

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
  goal_posts_.find(image, *view, carpet_color_, percept);
  obstacles_.find(carpet_map_, *view, percept);
  line_points_.find(image, *view, carpet_color_, percept);
}

void FieldFeatures::set_parameters(const FieldFeatureParameters& parameters) {
  carpet_color_.set_parameters(parameters);
  goal_posts_.set_parameters(parameters);
  obstacles_.set_parameters(parameters);
  line_points_.set_parameters(parameters);
}

}  // namespace reorient
