// SPDX-License-Identifier: MIT
#include "localization/calibration/line_offset.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "localization/measurement/field_line_map.h"

namespace reorient {
namespace {

constexpr double kFarthestSighting = 5.0;  // m, of a point on the ground
constexpr int kFewestOnLines = 60;         // points on lines
constexpr double kMissing = 1.0;           // rad, for a point without a line nearby

/// A point on a line as two lines of sight, which do not depend on the camera's pose.
struct Sighting {
  Eigen::Vector3d ray;
  Eigen::Vector3d farther;  // a little farther along the line
};

std::vector<Sighting> sightings_of(const LineView& view) {
  constexpr double kAlong = 0.05;  // m
  std::vector<Sighting> all;
  const Isometry3 camera_from_robot = view.found_from_camera.inverse();
  for (const LinePoint& point : view.line_points) {
    const Eigen::Vector2d farther = point.position + kAlong * unit_vector(point.normal + 0.5 * kPi);
    const Eigen::Vector3d ray = camera_from_robot * Eigen::Vector3d(farther.x(), farther.y(), 0.0);
    all.push_back({view.camera.ray(point.pixel.cast<double>()), ray});
  }
  return all;
}

/// The angle at the camera from the nearest line, signed, rad.
double angle_of(const Sighting& sighting, const Isometry3& robot_from_camera, const Pose2& robot,
                const FieldLineMap& lines) {
  const Eigen::Vector3d& origin = robot_from_camera.translation();
  const auto on_ground = [&](const Eigen::Vector3d& ray_in_camera) -> std::optional<Eigen::Vector2d> {
    const Eigen::Vector3d ray = robot_from_camera.linear() * ray_in_camera;
    if (ray.z() > -0.02 * ray.norm()) return std::nullopt;  // at the horizon, and above
    const Eigen::Vector2d from_camera = -origin.z() / ray.z() * ray.head<2>();
    if (from_camera.norm() > kFarthestSighting) return std::nullopt;
    return Eigen::Vector2d(origin.head<2>() + from_camera);
  };
  const std::optional<Eigen::Vector2d> place = on_ground(sighting.ray), farther = on_ground(sighting.farther);
  if (!place || !farther) return kMissing;
  const Eigen::Vector2d on_field = robot * *place;
  const Eigen::Vector2d direction = (robot * *farther - on_field).normalized();
  const std::optional<NearestFieldLine> line = lines.nearest(on_field, direction);
  if (!line) return kMissing;
  const Eigen::Vector2d on_line = on_field - line->distance * line->normal;
  const Eigen::Vector2d camera = robot * Eigen::Vector2d(origin.head<2>());
  const Eigen::Vector3d seen(on_field.x() - camera.x(), on_field.y() - camera.y(), -origin.z());
  const Eigen::Vector3d expected(on_line.x() - camera.x(), on_line.y() - camera.y(), -origin.z());
  return (line->distance < 0.0 ? -1.0 : 1.0) * pinned::atan2(seen.cross(expected).norm(), seen.dot(expected));
}

}  // namespace

OffsetEstimate offset_from_lines(std::span<const LineView> views, const FieldDimensions& field) {
  constexpr std::size_t kGridPoints = 1500;  // enough for the initial grid
  const FieldLineMap lines(field);
  std::vector<std::vector<Sighting>> sightings;
  std::vector<double> pixels;  // rad
  std::size_t count = 0;
  for (const LineView& view : views) {
    if (view.line_points.empty()) continue;
    count += view.line_points.size();
    pixels.push_back(1.0 / view.camera.focal.x());
  }
  if (count < kFewestOnLines) return {};
  for (const LineView& view : views) sightings.push_back(sightings_of(view));
  OffsetProblem problem;
  problem.images = views.size();
  problem.residuals = [&](std::size_t image, const CameraOffset& offset, std::size_t every,
                          std::vector<WeightedResidual>& residuals) {
    residuals.clear();
    const Isometry3 camera = turned(views[image].robot_from_camera, offset);
    for (std::size_t i = 0; i < sightings[image].size(); i += every)
      residuals.push_back({angle_of(sightings[image][i], camera, views[image].robot, lines), 1.0});
  };
  problem.observable = {true, true, true, true};
  problem.reach = {from_degrees(12.0), from_degrees(9.0), from_degrees(6.0), 0.0};
  problem.step = {from_degrees(1.0), from_degrees(1.5), from_degrees(2.0), 1.0};
  problem.prior = {from_degrees(10.0), from_degrees(10.0), from_degrees(10.0), 0.1};
  problem.window = kMostLineAngle;
  problem.cap = 0.5 * kMostLineAngle;
  // A quarter of a pixel.
  std::nth_element(pixels.begin(), pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2), pixels.end());
  problem.least_noise = 0.25 * pixels[pixels.size() / 2];
  problem.every = std::max<std::size_t>(1, count / kGridPoints);
  problem.least_inliers = 0.5;
  OffsetEstimate estimate = fit_offset(problem, {from_degrees(1.0), from_degrees(1.0), from_degrees(1.0), 0.03});
  if (estimate.inliers * static_cast<double>(count) < kFewestOnLines) return {};
  return estimate;
}

std::vector<WeightedResidual> line_angles(std::span<const LineView> views, const CameraOffset& offset,
                                          const FieldDimensions& field) {
  const FieldLineMap lines(field);
  std::vector<WeightedResidual> angles;
  for (const LineView& view : views) {
    const Isometry3 camera = turned(view.robot_from_camera, offset);
    for (const Sighting& sighting : sightings_of(view))
      angles.push_back({std::min(std::abs(angle_of(sighting, camera, view.robot, lines)), kMostLineAngle), 1.0});
  }
  return angles;
}

}  // namespace reorient
