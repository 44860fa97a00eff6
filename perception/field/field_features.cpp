#include "perception/field/field_features.h"

#include <algorithm>

namespace reorient {
namespace {

int highest_row_of_ground(const GroundProjection& view) {
  const double left = view.horizon(0.0);
  const double right = view.horizon(view.camera().width - 1.0);
  return static_cast<int>(std::clamp(std::min(left, right), 0.0, static_cast<double>(view.camera().height)));
}

}  // namespace

FieldFeatures::FieldFeatures(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : carpet_color_(parameters),
      goal_posts_(parameters, field),
      obstacles_(parameters),
      line_points_(parameters, field) {
  percept_.line_points.reserve(600);
  percept_.goal_posts.reserve(8);
  percept_.obstacles.reserve(20);
  see_nothing(0);
}

const FieldPercept& FieldFeatures::find(const ImageView& image, const CameraModel& camera,
                                        const Eigen::Isometry3d& robot_from_camera) {
  see_nothing(std::max(image.height, 0));
  if (image.empty() || image.width < 2) return percept_;
  const bool same_size = camera.width == image.width && camera.height == image.height;
  const auto view =
      GroundProjection::look(same_size ? camera : camera.scaled_to(image.width, image.height), robot_from_camera);
  if (!view) return percept_;

  carpet_color_.observe(image, *view);
  if (!carpet_color_.known()) return percept_;
  carpet_map_.fill(image, carpet_color_, highest_row_of_ground(*view));
  boundary_.find(carpet_map_, image.height, percept_.boundary);
  goal_posts_.find(image, *view, carpet_color_, percept_);
  obstacles_.find(carpet_map_, *view, percept_);
  line_points_.find(image, *view, carpet_color_, percept_);
  return percept_;
}

void FieldFeatures::set_parameters(const FieldFeatureParameters& parameters) {
  carpet_color_.set_parameters(parameters);
  goal_posts_.set_parameters(parameters);
  obstacles_.set_parameters(parameters);
  line_points_.set_parameters(parameters);
}

void FieldFeatures::see_nothing(int image_height) {
  percept_.line_points.clear();
  percept_.goal_posts.clear();
  percept_.obstacles.clear();
  percept_.boundary.assign(CarpetMap::kColumns, static_cast<float>(image_height));
}

}  // namespace reorient
