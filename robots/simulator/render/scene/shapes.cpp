// SPDX-License-Identifier: MIT
#include "robots/simulator/render/scene/shapes.h"

#include <algorithm>
#include <cmath>

#include "robots/simulator/render/coverage.h"
#include "robots/simulator/render/scene/drawing.h"

namespace reorient {
namespace {

/// The pixels of a parallelogram, for a simple pinhole.
Box box_of(const std::array<Eigen::Vector3f, 4>& corners, const RayTable& rays) {
  Bounds bounds(rays);
  bool seen = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Eigen::Vector3f from = corners[i];
    Eigen::Vector3f to = corners[(i + 1) % corners.size()];
    if (!clip(from, to, kNearest)) continue;
    seen = true;
    bounds.add(from, 0.0f);
    bounds.add(to, 0.0f);
  }
  return seen ? bounds.box() : Box{0, 0, -1, -1};
}

/// The same for any lens.
Box box_around(const Eigen::Vector3f& corner, const Eigen::Vector3f& along, const Eigen::Vector3f& up,
               const RayTable& rays) {
  constexpr int kStripes = 4;
  Cones cones(rays);
  for (int i = 0; i < kStripes; ++i) {
    const Eigen::Vector3f from = corner + (static_cast<float>(i) + 0.5f) / kStripes * up;
    cones.add_line(from, from + along, 0.5f * up.norm() / kStripes);
  }
  return cones.box();
}

/// A parallelogram in the camera frame, m.
struct ParallelogramInView {
  ParallelogramInView(const Eigen::Vector3f& field_corner, const Eigen::Vector3f& field_along,
                      const Eigen::Vector3f& field_up, const Eigen::Isometry3f& camera_from_field)
      : corner(camera_from_field * field_corner),
        along(camera_from_field.linear() * field_along),
        up(camera_from_field.linear() * field_up),
        normal(along.cross(up).normalized()),
        width(along.norm()),
        height(up.norm()),
        offset(corner.dot(normal)) {}

  /// The pixels that it can touch.
  Box box(const RayTable& rays) const {
    if (!rays.blocks.empty()) return box_around(corner, along, up, rays);
    return box_of({corner, corner + along, corner + along + up, corner + up}, rays);
  }
  /// Intersection of a ray and the plane.
  float depth(const Eigen::Vector3f& ray) const { return offset / ray.dot(normal); }
  struct Place {
    float u, v;  // m from the corner along its sides
  };
  Place place(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f inside = point - corner;
    return {inside.dot(along) / width, inside.dot(up) / height};
  }

  Eigen::Vector3f corner, along, up, normal;
  float width, height;
  float offset;  // of its plane from the camera, along the normal
};

/// The pixels of a shadow, for a simple pinhole.
Box box_of(const Shadow& shadow, const Eigen::Vector3f& center, const Eigen::Vector3f& forward,
           const Eigen::Vector3f& left, const RayTable& rays) {
  if (center.x() + shadow.radius < kNearest) return {0, 0, -1, -1};
  Bounds bounds(rays);
  if (center.x() - shadow.radius < kNearest) {
    bounds.add(center, shadow.radius);
  } else {
    for (const float x : {-shadow.radius, shadow.radius}) {
      for (const float y : {-shadow.radius, shadow.radius}) bounds.add(center + x * forward + y * left, 0.0f);
    }
  }
  return bounds.box();
}

}  // namespace

void draw(const Panel& panel, const Texture& texture, float gain, const RayTable& rays,
          const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  const ParallelogramInView view(panel.corner, panel.along, panel.up, camera_from_field);
  if (view.offset >= 0.0f) return;  // seen from behind
  for_each(view.box(rays), rays, frame, [&](std::size_t pixel, const Eigen::Vector3f& ray, float ray_length) {
    const float depth = view.depth(ray);
    if (!(depth > kNearest) || depth > frame.depth[pixel]) return;
    const auto [u, v] = view.place(depth * ray);
    const float footprint = depth * ray_length * rays.pixel_angle;
    const float coverage = covered_fraction(u, 0.5f * footprint, 0.0f, view.width) *
                           covered_fraction(v, 0.5f * footprint, 0.0f, view.height);
    if (coverage <= 0.0f) return;
    const int level = Texture::level_for(footprint * texture.texels_per_meter());
    const Texture::Color color = texture.sample(panel.u + u, panel.v + v, level);
    cover(frame, pixel, coverage, gain * LinearColor(color[0], color[1], color[2]), depth, Label::wall);
  });
}

void draw(const Net& net, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  constexpr float kMesh = 0.08f;     // m between strings
  constexpr float kString = 0.006f;  // m
  const ParallelogramInView view(net.corner, net.along, net.up, camera_from_field);
  const auto strings = [](float at, float half, float size) {
    if (at < -0.5f * kString || at > size + 0.5f * kString) return 0.0f;
    if (half > 0.5f * kMesh) return kString / kMesh;
    return covered_fraction(at - kMesh * std::round(at / kMesh), half, -0.5f * kString, 0.5f * kString);
  };
  for_each(view.box(rays), rays, frame, [&](std::size_t pixel, const Eigen::Vector3f& ray, float ray_length) {
    const float depth = view.depth(ray);
    if (!(depth > kNearest) || depth > frame.depth[pixel]) return;
    const auto [u, v] = view.place(depth * ray);
    if (u < 0.0f || u > view.width || v < 0.0f || v > view.height) return;
    const float half = 0.5f * depth * ray_length * rays.pixel_angle;
    const float open = (1.0f - strings(u, half, view.width)) * (1.0f - strings(v, half, view.height));
    blend(frame, pixel, 1.0f - open, net.color);  // depth and label stay those of the things behind the net
  });
}

void draw(const Shadow& shadow, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  const Eigen::Vector3f center = camera_from_field * Eigen::Vector3f(shadow.center.x(), shadow.center.y(), 0.0f);
  const Eigen::Vector3f forward = camera_from_field.linear().col(0);
  const Eigen::Vector3f left = camera_from_field.linear().col(1);
  const Eigen::Vector3f up = camera_from_field.linear().col(2);
  Box box{};
  if (rays.blocks.empty()) {
    box = box_of(shadow, center, forward, left, rays);
  } else {
    Cones cones(rays);
    cones.add(center, shadow.radius);
    box = cones.box();
  }
  const float offset = center.dot(up);
  for_each(box, rays, frame, [&](std::size_t pixel, const Eigen::Vector3f& ray, float) {
    const float depth = offset / ray.dot(up);
    if (!(depth > kNearest) || depth > frame.depth[pixel] * 1.001f) return;
    const float radius2 = (depth * ray - center).squaredNorm() / (shadow.radius * shadow.radius);
    if (radius2 >= 1.0f) return;
    const float light = 1.0f - shadow.darkness * (1.0f - radius2) * (1.0f - radius2);
    frame.red[pixel] *= light;
    frame.green[pixel] *= light;
    frame.blue[pixel] *= light;
  });
}

}  // namespace reorient
