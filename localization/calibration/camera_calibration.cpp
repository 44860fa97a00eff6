// SPDX-License-Identifier: MIT
#include "localization/calibration/camera_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/field_landmarks.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kTiltReach = from_degrees(12.0);
constexpr double kPanReach = from_degrees(8.0);
constexpr double kCap = from_degrees(1.5);           // larger errors are reduced to it
constexpr double kOnLine = from_degrees(0.5);        // largest angle between a line and a point on it
constexpr double kFarthestPoint = 5.0;               // m, of a point on the ground
constexpr int kFewest = 60;                          // points on lines
constexpr double kTurnedAside = from_degrees(35.0);  // largest difference in direction between a line and its points

struct Errors {
  double sum = 0.0;  // of squares, each at most kCap's
  int points = 0;
  int on_lines = 0;
  std::array<int, 2> on_directions{};  // along the field, across it

  double mean() const { return points > 0 ? sum / points : kCap * kCap; }
};

class Sightings {
 public:
  Sightings(std::span<const CalibrationView> views, const Pose2& robot, const FieldDimensions& field)
      : views_(views), robot_(robot), lines_(field_lines(field)), circle_(field.center_circle_radius) {}

  /// Uses one in `every` points.
  Errors errors(const CameraOffset& offset, std::size_t every = 1) const {
    Errors all;
    for (const CalibrationView& view : views_) {
      const Isometry3 camera = turned(view.robot_from_camera, offset);
      const double height = camera.translation().z();
      for (std::size_t i = 0; i < view.line_points.size(); i += every) {
        const LinePoint& point = view.line_points[i];
        const Eigen::Vector3d ray = camera.linear() * view.camera.ray(point.pixel.cast<double>());
        ++all.points;
        if (ray.z() > -0.02 * ray.norm()) {  // at the horizon, and above
          all.sum += kCap * kCap;
          continue;
        }
        const Eigen::Vector3d on_ground = camera.translation() - height / ray.z() * ray;
        const double distance = (on_ground - camera.translation()).head<2>().norm();
        int direction = 0;
        const double off = distance < kFarthestPoint ? off_lines(robot_ * Eigen::Vector2d(on_ground.head<2>()),
                                                                 robot_.rotation + point.normal, direction)
                                                     : kFarthestPoint;
        // As an angle at the camera, along the ray.
        const double angle = std::min(off * height / (distance * distance + height * height), kCap);
        all.sum += angle * angle;
        if (angle > kOnLine) continue;
        ++all.on_lines;
        if (direction < 2) ++all.on_directions[static_cast<std::size_t>(direction)];
      }
    }
    return all;
  }

 private:
  /// Distance from the nearest line with about this normal, m. Sets the type of this line: 0 along the field, 1 across
  /// it, 2 the circle.
  double off_lines(const Eigen::Vector2d& place, double normal, int& type) const {
    double nearest = kFarthestPoint;
    const auto differs = [normal](double other) {
      const double turn = std::abs(angle_difference(normal, other));
      return std::min(turn, kPi - turn) > kTurnedAside;
    };
    for (const FieldLine& line : lines_) {
      const Eigen::Vector2d along = line.to - line.from;
      if (differs(pinned::atan2(along.x(), -along.y()))) continue;
      const double fraction = std::clamp((place - line.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double off = (place - line.from - fraction * along).norm();
      if (off >= nearest) continue;
      nearest = off;
      type = std::abs(along.x()) > std::abs(along.y()) ? 0 : 1;
    }
    const double radius = place.norm();
    if (radius > 1e-6 && !differs(pinned::atan2(place.y(), place.x())) && std::abs(radius - circle_) < nearest) {
      nearest = std::abs(radius - circle_);
      type = 2;
    }
    return nearest;
  }

  std::span<const CalibrationView> views_;
  Pose2 robot_;
  std::vector<FieldLine> lines_;
  double circle_;
};

}  // namespace

std::optional<CameraCorrection> calibrate(std::span<const CalibrationView> views, const Pose2& robot,
                                          const FieldDimensions& field) {
  const Sightings sightings(views, robot, field);
  // Starts with a grid: near the truth the error has one minimum, farther away it has one for each line.
  constexpr double kStep = from_degrees(0.5);
  constexpr std::size_t kRoughly = 10;  // for the grid one in ten points is enough
  CameraOffset offset;
  double best = sightings.errors(offset, kRoughly).mean();
  for (double t = -kTiltReach; t <= kTiltReach; t += kStep) {
    for (double p = -kPanReach; p <= kPanReach; p += kStep) {
      const double error = sightings.errors({t, p}, kRoughly).mean();
      if (error >= best) continue;
      best = error;
      offset = {t, p};
    }
  }
  best = sightings.errors(offset).mean();
  for (double step = 0.5 * kStep; step > from_degrees(0.005);) {
    bool any = false;
    for (const auto& [t, p] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const CameraOffset tried{offset.tilt + t, offset.pan + p};
      const double error = sightings.errors(tried).mean();
      if (error >= best) continue;
      best = error;
      offset = tried;
      any = true;
      break;
    }
    if (!any) step *= 0.5;
  }
  const Errors after = sightings.errors(offset);
  if (after.on_lines < kFewest || 2 * after.on_lines < after.points ||
      *std::min_element(after.on_directions.begin(), after.on_directions.end()) < kFewest / 4)
    return std::nullopt;
  return CameraCorrection{offset, std::sqrt(sightings.errors({}).mean()), std::sqrt(best), after.on_lines};
}

}  // namespace reorient
