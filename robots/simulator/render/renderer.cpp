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

Renderer::Renderer(const CameraModel& camera, const FieldDimensions& field, const Room& room, bool with_labels)
    : rays_(camera), background_(field, room, camera.width), frame_(camera.width, camera.height, with_labels) {}

const Frame& Renderer::render(const Isometry3& field_from_camera, const Scene& scene) {
  const Eigen::Isometry3f camera = inside(background_.room(), field_from_camera);
  background_.render(rays_, camera, frame_);

  // What is far away first, so that soft edges blend with what is behind them.
  const Eigen::Isometry3f camera_from_field = camera.inverse();
  const Eigen::Vector3f eye = camera.translation();
  order_.clear();
  for (std::size_t i = 0; i < scene.capsules.size(); ++i) {
    const Capsule& capsule = scene.capsules[i];
    order_.push_back({(0.5f * (capsule.from + capsule.to) - eye).norm(), static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < scene.nets.size(); ++i) {
    const Net& net = scene.nets[i];
    order_.push_back({(net.corner + 0.5f * (net.along + net.up) - eye).norm(), -1 - static_cast<int>(i)});
  }
  std::sort(order_.begin(), order_.end(), [](const Drawn& a, const Drawn& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.index < b.index;
  });
  for (const Shadow& shadow : scene.shadows) draw(shadow, rays_, camera_from_field, frame_);
  for (const Drawn& drawn : order_) {
    if (drawn.index >= 0) {
      draw(scene.capsules[static_cast<std::size_t>(drawn.index)], rays_, camera_from_field, frame_);
    } else {
      draw(scene.nets[static_cast<std::size_t>(-1 - drawn.index)], rays_, camera_from_field, frame_);
    }
  }
  return frame_;
}

}  // namespace reorient
