// SPDX-License-Identifier: MIT
#include "tests/perception/field/flat_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace reorient {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

NearestLine to_segment(const Vector2d& from, const Vector2d& to, const Vector2d& point) {
  const Vector2d along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return {(point - from - share * along).norm(), std::atan2(along.x(), -along.y())};
}

void nearer(NearestLine& best, const NearestLine& other) {
  if (other.distance < best.distance) best = other;
}

/// An area that is open toward its goal line, on the side `side` (+1 or -1).
void area(NearestLine& best, const FieldDimensions& f, double side, double depth, double width, const Vector2d& point) {
  if (depth <= 0.0) return;
  const double goal_line = side * 0.5 * f.length;
  const double front = goal_line - side * depth;
  const double half = 0.5 * width;
  nearer(best, to_segment({front, -half}, {front, half}, point));
  nearer(best, to_segment({front, half}, {goal_line, half}, point));
  nearer(best, to_segment({front, -half}, {goal_line, -half}, point));
}

bool is_carpet(const FieldDimensions& f, const Vector2d& point) {
  return std::abs(point.x()) < 0.5 * f.length + f.border && std::abs(point.y()) < 0.5 * f.width + f.border;
}

/// Distance at which a ray enters a box (slab method). Infinity if it does not.
double enter(const Box& box, const Vector3d& origin, const Vector3d& ray) {
  const double half = 0.5 * box.width;
  const std::array<double, 3> low{box.position.x() - half, box.position.y() - half, 0.0};
  const std::array<double, 3> high{box.position.x() + half, box.position.y() + half, box.height};
  double in = 0.0;
  double out = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    const double a = (low[axis] - origin[i]) / ray[i];
    const double b = (high[axis] - origin[i]) / ray[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out ? in : std::numeric_limits<double>::infinity();
}

/// The same for a sphere on the ground.
double enter(const Sphere& sphere, const Vector3d& origin, const Vector3d& ray) {
  const Vector3d out = origin - Vector3d(sphere.position.x(), sphere.position.y(), sphere.radius);
  const double a = ray.squaredNorm(), b = out.dot(ray), c = out.squaredNorm() - sphere.radius * sphere.radius;
  const double root = b * b - a * c;
  return root >= 0.0 && b < 0.0 ? (-b - std::sqrt(root)) / a : std::numeric_limits<double>::infinity();
}

bool is_on_mark(const FieldDimensions& f, const Vector2d& point) {
  const Vector2d off(std::abs(std::abs(point.x()) - f.penalty_mark_x), std::abs(point.y()));
  return off.maxCoeff() < 0.5 * f.penalty_mark_size && off.minCoeff() < 0.5 * f.line_width;
}

Ycbcr look(const FlatField& scene, const Vector3d& origin, const Vector3d& ray) {
  double nearest = ray.z() < -1e-6 ? -origin.z() / ray.z() : std::numeric_limits<double>::infinity();
  Ycbcr color = scene.colors.wall;
  if (std::isfinite(nearest)) {
    const Vector2d point = (origin + nearest * ray).head<2>();
    if (is_carpet(scene.field, point)) {
      const bool line = (scene.lines && nearest_line(scene.field, point).distance < 0.5 * scene.field.line_width) ||
                        (scene.marks && is_on_mark(scene.field, point));
      color = line ? scene.colors.line : scene.colors.carpet;
    }
  }
  for (const Box& box : scene.boxes) {
    const double distance = enter(box, origin, ray);
    if (distance >= nearest) continue;
    nearest = distance;
    color = box.color;
  }
  for (const Sphere& sphere : scene.spheres) {
    const double distance = enter(sphere, origin, ray);
    if (distance >= nearest) continue;
    nearest = distance;
    color = sphere.color;
  }
  return color;
}

}  // namespace

FlatField FlatField::with_goals() {
  FlatField scene;
  const FieldDimensions& f = scene.field;
  for (const double side : {-1.0, 1.0}) {
    for (const double y : {-f.goal_post_y, f.goal_post_y}) {
      scene.boxes.push_back({{side * 0.5 * f.length, y}, f.goal_post_diameter, f.goal_height, scene.colors.post});
    }
  }
  return scene;
}

NearestLine nearest_line(const FieldDimensions& f, const Vector2d& point) {
  NearestLine best;
  const double x = 0.5 * f.length;
  const double y = 0.5 * f.width;
  for (const double side : {-1.0, 1.0}) {
    nearer(best, to_segment({-x, side * y}, {x, side * y}, point));
    nearer(best, to_segment({side * x, -y}, {side * x, y}, point));
    area(best, f, side, f.penalty_area_depth, f.penalty_area_width, point);
    area(best, f, side, f.goal_area_depth, f.goal_area_width, point);
  }
  nearer(best, to_segment({0.0, -y}, {0.0, y}, point));
  nearer(best, {std::abs(point.norm() - f.center_circle_radius), std::atan2(point.y(), point.x())});
  const Vector2d out = point - Vector2d(std::copysign(x, point.x()), std::copysign(y, point.y()));
  if (f.corner_arc_radius > 0.0 && std::abs(point.x()) < x && std::abs(point.y()) < y)
    nearer(best, {std::abs(out.norm() - f.corner_arc_radius), std::atan2(out.y(), out.x())});
  return best;
}

Image render(const FlatField& scene, const CameraModel& camera, const Isometry3& field_from_camera) {
  Image image(camera.width, camera.height);
  const Vector3d origin = field_from_camera.translation();
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; x += 2) {
      std::uint8_t* pair = image.row(y) + 2 * x;
      int cb = 0, cr = 0;
      for (int i = 0; i < 2; ++i) {
        int luma = 0;
        for (const double dx : {-0.25, 0.25}) {
          for (const double dy : {-0.25, 0.25}) {
            const Ycbcr seen = look(scene, origin, field_from_camera.linear() * camera.ray({x + i + dx, y + dy}));
            luma += seen.y;
            cb += seen.cb;
            cr += seen.cr;
          }
        }
        pair[2 * i] = static_cast<std::uint8_t>(luma / 4);
      }
      pair[1] = static_cast<std::uint8_t>(cb / 8);
      pair[3] = static_cast<std::uint8_t>(cr / 8);
    }
  }
  return image;
}

}  // namespace reorient
