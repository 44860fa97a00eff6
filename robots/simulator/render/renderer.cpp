// SPDX-License-Identifier: MIT
#include "robots/simulator/render/renderer.h"

#include <algorithm>

namespace reorient {
namespace {

Eigen::Isometry3f inside(const Room& room, const Isometry3& field_from_camera) {
  constexpr double kMargin = 0.05;  // m
  const Eigen::Vector2d half = 0.5 * floor_extent(room.shape);
  Isometry3 kept = field_from_camera;
  Eigen::Vector3d position = kept.translation();
  position.z() = std::clamp(position.z(), 0.02, room.shape.height - kMargin);
  if (room.shape.form == RoomForm::box) {
    position.x() = std::clamp(position.x(), kMargin - half.x(), half.x() - kMargin);
    position.y() = std::clamp(position.y(), kMargin - half.y(), half.y() - kMargin);
  } else if (position.head<2>().norm() > half.x() - kMargin) {
    position.head<2>() *= (half.x() - kMargin) / position.head<2>().norm();
  }
  kept.translation() = position;
  return kept.cast<float>();
}

}  // namespace

Renderer::Renderer(const CameraModel& camera, const FieldDimensions& field, const Room& room, bool with_labels,
                   double worn_lines)
    : rays_(camera),
      background_(field, room, camera.width, worn_lines),
      frame_(camera.width, camera.height, with_labels) {}

const RayTable& Renderer::rays_of_frame(const Eigen::Vector3d& angular_velocity, double readout_time) {
  if (readout_time <= 0.0 || angular_velocity.isZero(0.0)) return rays_;
  if (!turned_rays_) turned_rays_ = rays_;
  turned_rays_->turn_while_read(rays_, angular_velocity, readout_time);
  return *turned_rays_;
}

void Renderer::light(const Scene& scene) {
  capsules_ = scene.capsules;
  for (Capsule& capsule : capsules_) {
    const Eigen::Vector3f middle = 0.5f * (capsule.from + capsule.to);
    capsule.color *= scene.illumination.gain(middle.x(), middle.y());
  }
}

/// Panels are drawn first, because all other things are on the field, in front of them.
void Renderer::draw_panels(const Scene& scene, const RayTable& rays, const Eigen::Isometry3f& camera_from_field,
                           const Eigen::Vector3f& eye) {
  order_.clear();
  for (std::size_t i = 0; i < scene.panels.size(); ++i)
    order_.push_back({(scene.panels[i].middle() - eye).norm(), static_cast<int>(i)});
  sort_far_first();
  for (const Drawn& drawn : order_) {
    const Panel& panel = scene.panels[static_cast<std::size_t>(drawn.index)];
    const Eigen::Vector3f middle = panel.middle();
    const float gain = scene.illumination.as_usual() ? 1.0f : scene.illumination.gain(middle.x(), middle.y());
    draw(panel, background_.room().walls, gain, rays, camera_from_field, frame_);
  }
}

void Renderer::sort_far_first() {
  std::sort(order_.begin(), order_.end(), [](const Drawn& a, const Drawn& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.index < b.index;
  });
}

const Frame& Renderer::render(const Isometry3& field_from_camera, const Scene& scene,
                              const Eigen::Vector3d& angular_velocity, double readout_time) {
  const Eigen::Isometry3f camera = inside(background_.room(), field_from_camera);
  const RayTable& rays = rays_of_frame(angular_velocity, readout_time);
  background_.render(rays, camera, {scene.illumination, scene.patches}, frame_);
  if (!scene.illumination.as_usual()) light(scene);
  const std::vector<Capsule>& capsules = scene.illumination.as_usual() ? scene.capsules : capsules_;

  // Far things first, so that soft edges blend with the things behind them.
  const Eigen::Isometry3f camera_from_field = camera.inverse();
  const Eigen::Vector3f eye = camera.translation();
  draw_panels(scene, rays, camera_from_field, eye);
  const Frustum frustum(rays, camera_from_field);
  order_.clear();
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    const Capsule& capsule = capsules[i];
    if (!frustum.may_show(capsule)) continue;
    order_.push_back({(0.5f * (capsule.from + capsule.to) - eye).norm(), static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < scene.nets.size(); ++i) {
    const Net& net = scene.nets[i];
    order_.push_back({(net.corner + 0.5f * (net.along + net.up) - eye).norm(), -1 - static_cast<int>(i)});
  }
  sort_far_first();
  for (const Shadow& shadow : scene.shadows) draw(shadow, rays, camera_from_field, frame_);
  for (const Drawn& drawn : order_) {
    if (drawn.index >= 0) {
      draw(capsules[static_cast<std::size_t>(drawn.index)], rays, camera_from_field, frame_);
    } else {
      draw(scene.nets[static_cast<std::size_t>(-1 - drawn.index)], rays, camera_from_field, frame_);
    }
  }
  return frame_;
}

}  // namespace reorient
