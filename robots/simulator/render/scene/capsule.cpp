// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/wide.h"
#include "robots/simulator/render/coverage.h"
#include "robots/simulator/render/scene/drawing.h"
#include "robots/simulator/render/scene/shapes.h"

namespace reorient {
namespace {

/// The centers of the twelve dark patches of a football are the corners of an icosahedron.
bool on_patch(const Eigen::Vector3f& normal) {
  constexpr float kShort = 0.525731f;
  constexpr float kLong = 0.850651f;
  constexpr float kReach = 0.93f;  // cosine of a patch's angular radius
  const Eigen::Vector3f n = normal.cwiseAbs();
  return kShort * n.x() + kLong * n.y() > kReach || kShort * n.y() + kLong * n.z() > kReach ||
         kShort * n.z() + kLong * n.x() > kReach;
}

/// A capsule in the camera frame.
struct CapsuleInView {
  CapsuleInView(const Capsule& what, const RayTable& table, const Eigen::Isometry3f& camera_from_field)
      : capsule(what),
        rays(table),
        field_from_camera(camera_from_field.linear().transpose()),
        up(camera_from_field.linear().col(2)),
        from(camera_from_field * what.from) {
    const Eigen::Vector3f line = camera_from_field * what.to - from;
    length = line.norm();
    axis = length > 1e-6f ? Eigen::Vector3f(line / length) : up;
    eye_along = -axis.dot(from);
    constexpr float kFar = 1e6f;
    least = what.flat_ends ? -kFar : 0.0f;
    most = what.flat_ends ? kFar : length;
  }

  /// The closest points of a ray and the axis: meters along the ray and along the (infinite) line of the axis.
  struct Closest {
    float toward, cosine, sine2, anywhere, along, t;
  };

  [[gnu::always_inline]] Closest closest(const Eigen::Vector3f& direction) const {
    Closest c{};
    c.toward = -(direction.x() * from.x() + direction.y() * from.y() + direction.z() * from.z());
    c.cosine = direction.x() * axis.x() + direction.y() * axis.y() + direction.z() * axis.z();
    const float left = 1.0f - c.cosine * c.cosine;
    c.sine2 = left > 1e-6f ? left : 1e-6f;
    c.anywhere = (eye_along - c.cosine * c.toward) / c.sine2;
    const float from_least = c.anywhere > least ? c.anywhere : least;
    c.along = from_least < most ? from_least : most;
    c.t = c.along * c.cosine - c.toward;
    return c;
  }

  /// Determines which of the kLanes pixels from `first` the capsule may touch. False: none. Written for SIMD.
  template <bool perspective>
  [[gnu::always_inline]] bool find(std::size_t first, std::array<bool, kLanes>& near) const {
    float clear[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t pixel = first + static_cast<std::size_t>(lane);
      const float scale = 1.0f / rays.length[pixel];
      const float forward = perspective ? scale : rays.forward[pixel] * scale;
      const Eigen::Vector3f direction(forward, rays.left[pixel] * scale, rays.up[pixel] * scale);
      const Closest c = closest(direction);
      const float x = c.t * direction.x() - from.x() - c.along * axis.x();
      const float y = c.t * direction.y() - from.y() - c.along * axis.y();
      const float z = c.t * direction.z() - from.z() - c.along * axis.z();
      const float reach = capsule.radius + 0.5f * c.t * rays.pixel_angle;
      clear[lane] = c.t < kNearest ? 1.0f : x * x + y * y + z * z - reach * reach;
    }
    bool any = false;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      near[lane] = clear[lane] < 0.0f;
      any = any || near[lane];
    }
    return any;
  }

  /// Computes what the kLanes pixels from `first` show of the capsule. Written for SIMD.
  struct Look {
    float coverage[kLanes];      // in [0, 1]
    float between_ends[kLanes];  // fraction between the ends of a cylinder, in [0, 1]
    float depth[kLanes];         // m
    float shade[kLanes];         // factor on the color
    float normal_x[kLanes], normal_y[kLanes], normal_z[kLanes];
  };

  template <bool perspective>
  [[gnu::always_inline]] void look(std::size_t first, Look& seen) const {
    const float radius = capsule.radius;
#pragma GCC ivdep
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t pixel = first + static_cast<std::size_t>(lane);
      const float ray = rays.length[pixel];
      const float forward = perspective ? 1.0f : rays.forward[pixel];
      const Eigen::Vector3f direction(forward / ray, rays.left[pixel] / ray, rays.up[pixel] / ray);
      const Closest c = closest(direction);
      const float apart_x = c.t * direction.x() - from.x() - c.along * axis.x();
      const float apart_y = c.t * direction.y() - from.y() - c.along * axis.y();
      const float apart_z = c.t * direction.z() - from.z() - c.along * axis.z();
      const float half_pixel = 0.5f * c.t * rays.pixel_angle;
      const float distance = std::sqrt(apart_x * apart_x + (apart_y * apart_y + apart_z * apart_z));
      const float free = radius * radius - distance * distance;
      const float sagitta = std::sqrt(free > 0.0f ? free : 0.0f);
      const float slanted = sagitta / std::sqrt(c.sine2);
      const float from_side = c.anywhere >= 0.0f ? slanted : sagitta;
      const float to_surface = c.t - (c.anywhere <= length ? from_side : sagitta);
      const float surface = to_surface > kNearest ? to_surface : kNearest;
      seen.coverage[lane] = covered_fraction(distance, half_pixel, -radius, radius);
      seen.between_ends[lane] = covered_fraction(eye_along + c.cosine * surface, half_pixel, 0.0f, length);
      seen.depth[lane] = surface / ray;
      const float from_start = c.along > 0.0f ? c.along : 0.0f;
      const float along = from_start < length ? from_start : length;
      const float x = (surface * direction.x() - (from.x() + along * axis.x())) / radius;
      const float y = (surface * direction.y() - (from.y() + along * axis.y())) / radius;
      const float z = (surface * direction.z() - (from.z() + along * axis.z())) / radius;
      // Light from lamps above, a little more from one side, and light that the ground reflects.
      const float shade = 0.66f + 0.34f * (x * up.x() + (y * up.y() + z * up.z())) - 0.12f * y;
      const float bright = shade > 0.2f ? shade : 0.2f;
      seen.shade[lane] = bright < 1.2f ? bright : 1.2f;
      seen.normal_x[lane] = x;
      seen.normal_y[lane] = y;
      seen.normal_z[lane] = z;
    }
  }

  void paint(std::size_t pixel, const Look& seen, int lane, Frame& frame) const {
    const float coverage = capsule.flat_ends ? seen.coverage[lane] * seen.between_ends[lane] : seen.coverage[lane];
    if (coverage <= 0.0f || seen.depth[lane] > frame.depth[pixel]) return;
    const Eigen::Vector3f normal(seen.normal_x[lane], seen.normal_y[lane], seen.normal_z[lane]);
    const bool dark = capsule.football && on_patch(field_from_camera * normal);
    const float shade = dark ? 0.06f * seen.shade[lane] : seen.shade[lane];
    cover(frame, pixel, coverage, capsule.color * shade, seen.depth[lane], capsule.label);
  }

  const Capsule& capsule;
  const RayTable& rays;
  Eigen::Matrix3f field_from_camera;  // directions only
  Eigen::Vector3f up;
  Eigen::Vector3f from;
  Eigen::Vector3f axis;
  float length = 0.0f;
  float least = 0.0f, most = 0.0f;  // limits of the closest point on the axis; the ends of a cylinder are cut later
  float eye_along = 0.0f;           // position of the camera along the axis, m from `from`
};

template <bool perspective>
[[gnu::always_inline]] inline void draw_through(const Box& box, const CapsuleInView& view, Frame& frame) {
  std::array<bool, kLanes> near{};
  CapsuleInView::Look seen;
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; x += kLanes) {
      const int start = std::min(x, frame.width - kLanes);  // some pixels twice rather than the next row's
      const std::size_t first = frame.row(y) + static_cast<std::size_t>(start);
      if (!view.find<perspective>(first, near)) continue;
      view.look<perspective>(first, seen);
      for (int lane = x - start; lane < kLanes; ++lane) {
        if (near[static_cast<std::size_t>(lane)]) view.paint(first + static_cast<std::size_t>(lane), seen, lane, frame);
      }
    }
  }
}

REORIENT_WIDE void draw_in(const Box& box, const CapsuleInView& view, Frame& frame) {
  draw_through<true>(box, view, frame);
}

REORIENT_WIDE void draw_through_any_lens(const Box& box, const CapsuleInView& view, Frame& frame) {
  draw_through<false>(box, view, frame);
}

}  // namespace

Frustum::Frustum(const RayTable& rays, const Eigen::Isometry3f& camera_from_field)
    : camera_from_field_(camera_from_field),
      most_off_axis_(rays.blocks.empty() ? std::nullopt : std::optional(rays.most_off_axis + rays.angle_slack)) {
  const auto side = [](float across, float up, float steepest) {
    const float length = std::sqrt(1.0f + steepest * steepest);
    return Side{across / length, up / length, -steepest / length};
  };
  sides_ = {side(1.0f, 0.0f, rays.most_left), side(-1.0f, 0.0f, rays.most_right), side(0.0f, 1.0f, rays.most_up),
            side(0.0f, -1.0f, rays.most_down)};
}

bool Frustum::may_show(const Capsule& capsule) const {
  constexpr float kRounding = 1e-3f;  // m
  const Eigen::Vector3f center = camera_from_field_ * Eigen::Vector3f(0.5f * (capsule.from + capsule.to));
  const float radius = capsule.radius + 0.5f * (capsule.to - capsule.from).norm() + kRounding;
  if (most_off_axis_) {
    const float distance = center.norm();
    if (distance <= radius) return true;
    const auto reach = static_cast<float>(pinned::asin(radius / distance));
    return angle_between(center, Eigen::Vector3f::UnitX()) - reach <= *most_off_axis_;
  }
  if (center.x() + radius < kNearest) return false;
  return std::none_of(sides_.begin(), sides_.end(), [&](const Side& side) {
    return side.across * center.y() + side.up * center.z() + side.ahead * center.x() > radius;
  });
}

void draw(const Capsule& capsule, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  const CapsuleInView view(capsule, rays, camera_from_field);
  Eigen::Vector3f from = view.from;
  Eigen::Vector3f to = view.from + view.length * view.axis;
  if (!rays.blocks.empty()) {
    Cones cones(rays);
    cones.add_line(from, to, capsule.radius);
    if (rays.is_perspective()) {
      draw_in(cones.box(), view, frame);
    } else {
      draw_through_any_lens(cones.box(), view, frame);
    }
    return;
  }
  if (!clip(from, to, kNearest - capsule.radius)) return;
  Bounds bounds(rays);
  bounds.add(from, capsule.radius);
  bounds.add(to, capsule.radius);
  draw_in(bounds.box(), view, frame);
}

}  // namespace reorient
