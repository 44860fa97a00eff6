// SPDX-License-Identifier: MIT
#include "engine/detector_views.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/square.h"

namespace reorient {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Direction of a pixel at or above the horizon, along the ground.
Vector2d away_from(const GroundProjection& view, const Vector2d& pixel) {
  const Vector2d below(pixel.x(), view.camera().height - 1.0);
  const auto near = view.ground(below);
  return near ? view.away(*near) : Vector2d(1.0, 0.0);
}

}  // namespace

DetectorViews::DetectorViews(const DetectorCameras& cameras, const FieldDimensions& field)
    : farthest_(pinned::hypot(field.length + 2.0 * field.border, field.width + 2.0 * field.border)) {
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (!cameras[i]) continue;
    is_there_[i] = true;
    measured_[i] = GroundProjection::look(cameras[i]->camera, cameras[i]->measured);
    corrected_[i] = GroundProjection::look(cameras[i]->camera, cameras[i]->corrected);
    if (!measured_[i]) corrected_[i].reset();
  }
}

std::optional<DetectedPoint> DetectorViews::point(PerceptSpace space, const Vector2d& sent, double height) const {
  DetectedPoint seen{sent};
  if (space == PerceptSpace::ground) {
    seen.camera = is_there_[0] ? 0 : 1;
    for (std::size_t i = 0; i < corrected_.size() && seen.view == nullptr; ++i) {
      if (!corrected_[i]) continue;
      const auto pixel = measured_[i]->pixel(Vector3d(sent.x(), sent.y(), 0.0));
      if (!pixel || !corrected_[i]->camera().contains(*pixel)) continue;
      const auto position = corrected_[i]->ground(*pixel);
      if (position) seen = {*position, *pixel, i, &*corrected_[i]};
    }
  } else {
    seen.camera = space == PerceptSpace::upper_image ? 0 : 1;
    const std::optional<GroundProjection>& view = corrected_[seen.camera];
    const auto position = view ? view->at_height(sent, height) : std::nullopt;
    if (!position) return std::nullopt;
    seen = {*position, sent, seen.camera, &*view};
  }
  if (!is_there_[seen.camera] || !(seen.position.norm() <= farthest_)) return std::nullopt;
  return seen;
}

Matrix2d DetectorViews::covariance(const ExternalPercept& percept, const DetectedPoint& seen,
                                   const FieldFeatureParameters& features) const {
  Matrix2d sent;
  if (percept.covariance)
    sent << (*percept.covariance)[0], (*percept.covariance)[1], (*percept.covariance)[1], (*percept.covariance)[2];
  if (percept.covariance && percept.space == PerceptSpace::ground) return sent;
  if (seen.view == nullptr) return square(0.05 + 0.05 * seen.position.norm()) * Matrix2d::Identity();
  if (percept.covariance) {
    const auto right = seen.view->ground(seen.pixel + Vector2d(1.0, 0.0));
    const auto down = seen.view->ground(seen.pixel + Vector2d(0.0, 1.0));
    const auto here = seen.view->ground(seen.pixel);
    if (right && down && here) {
      Matrix2d ground_from_pixel;
      ground_from_pixel << *right - *here, *down - *here;
      return ground_from_pixel * sent * ground_from_pixel.transpose() +
             seen.view->covariance(seen.position, features.attitude_deviation);
    }
  }
  return seen.view->covariance(seen.position, features.attitude_deviation, seen.pixel, features.pixel_deviation);
}

std::optional<double> DetectorViews::direction(const ExternalPercept& percept, const DetectedPoint& seen) const {
  if (!percept.direction || percept.space == PerceptSpace::ground) return percept.direction;
  const Vector2d step = 2.0 * unit_vector(*percept.direction);
  const auto from = seen.view->ground(seen.pixel - step), to = seen.view->ground(seen.pixel + step);
  if (!from || !to || !((*to - *from).norm() > 1e-9)) return std::nullopt;
  return direction_of(*to - *from);
}

std::optional<Obstacle> DetectorViews::box_in(const ExternalPercept& percept, std::size_t camera) const {
  if (!is_there_[camera]) return std::nullopt;
  if (percept.space == PerceptSpace::ground) return projected_box(percept, camera);
  if ((percept.space == PerceptSpace::upper_image ? 0u : 1u) != camera || !corrected_[camera]) return std::nullopt;
  const Vector2d feet(0.5 * (percept.at[0] + percept.at[2]), percept.at[3]);
  Obstacle box;
  const auto position = corrected_[camera]->ground(feet);
  // Feet at or above the horizon: far behind the field.
  const bool is_on_field = position && position->norm() <= farthest_;
  box.position = is_on_field ? *position : farthest_ * away_from(*corrected_[camera], feet);
  return clipped(box, {percept.at[0], percept.at[1]}, {percept.at[2], percept.at[3]}, camera);
}

std::optional<Obstacle> DetectorViews::projected_box(const ExternalPercept& percept, std::size_t camera) const {
  constexpr double kWidth = 0.5, kRobot = 0.8, kPerson = 1.9;  // m, of things whose size was not sent
  constexpr double kNearest = 0.2;                             // m
  const std::optional<GroundProjection>& view = measured_[camera];
  const Vector2d position = Vector2d(percept.at[0], percept.at[1]);
  if (!view || !(view->distance(position) > kNearest)) return std::nullopt;
  const double half = 0.5 * (percept.at[2] > 0.0 ? percept.at[2] : kWidth);
  const double height = percept.at[3] > 0.0 ? percept.at[3] : percept.type == PerceptType::robot ? kRobot : kPerson;
  const Vector2d sight = view->away(position), beside(-sight.y(), sight.x());
  Vector2d least = Vector2d::Constant(1e6), most = Vector2d::Constant(-1e6);
  for (const double side : {-half, half}) {
    for (const double up : {0.0, height}) {
      const Vector2d place = position + side * beside;
      const auto pixel = view->pixel(Vector3d(place.x(), place.y(), up));
      if (!pixel) return std::nullopt;
      least = least.cwiseMin(*pixel);
      most = most.cwiseMax(*pixel);
    }
  }
  Obstacle box;
  box.position = position;
  return clipped(box, least, most, camera);
}

/// Nothing outside of the image.
std::optional<Obstacle> DetectorViews::clipped(Obstacle box, const Vector2d& least, const Vector2d& most,
                                               std::size_t camera) const {
  const double width = corrected_[camera]->camera().width - 1.0, height = corrected_[camera]->camera().height - 1.0;
  if (most.x() < 0.0 || most.y() < 0.0 || least.x() > width || least.y() > height) return std::nullopt;
  box.left = static_cast<int>(std::clamp(least.x(), 0.0, width));
  box.right = static_cast<int>(std::clamp(most.x(), 0.0, width));
  box.top = static_cast<int>(std::clamp(least.y(), 0.0, height));
  box.bottom = static_cast<int>(std::clamp(most.y(), 0.0, height));
  return box;
}

}  // namespace reorient
