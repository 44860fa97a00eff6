// SPDX-License-Identifier: MIT
#include "perception/room/wall/wall.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr double kSteepest = 1e-3;  // horizontal part of a direction, below which it has no azimuth

/// Distance, in multiples of `direction`, from a point inside a circle around the origin to the circle.
double steps_to_circle(const Eigen::Vector2d& from, const Eigen::Vector2d& direction, double radius) {
  const double a = direction.squaredNorm();
  const double b = from.dot(direction);
  const double c = from.squaredNorm() - radius * radius;
  return (-b + std::sqrt(std::max(b * b - a * c, 0.0))) / a;
}

}  // namespace

Wall::Wall(const WallParameters& parameters)
    : radius_(std::max(parameters.radius, 0.1)),
      bottom_(parameters.bottom),
      top_(std::max(parameters.top, parameters.bottom + 0.01)),
      rows_(std::max(parameters.rows, 1)),
      columns_(std::clamp(parameters.columns, 1, kMostColumns)) {
  columns_ += columns_ % 2;
  directions_.reserve(static_cast<std::size_t>(2 * columns_ + 1));
  for (int half = 0; half <= 2 * columns_; ++half) directions_.push_back(unit_vector(0.5 * half * column_width()));
}

int Wall::reflected(int tile) const {
  const int column = column_of(tile) + columns_ / 2;
  return row_of(tile) * columns_ + column % columns_;
}

double Wall::column_at(double azimuth) const {
  const double turns = azimuth / (2.0 * kPi);
  const double column = (turns < 0.0 ? turns + 1.0 : turns) * columns_;
  return column < columns_ ? column : 0.0;
}

/// Unit vector from the center.
Eigen::Vector2d Wall::direction(double column) const {
  const double half = 2.0 * column;
  const bool is_known = half >= 0.0 && half < static_cast<double>(directions_.size()) && half == std::floor(half);
  return is_known ? directions_[static_cast<std::size_t>(half)] : unit_vector(column * column_width());
}

Eigen::Vector3d Wall::point(double column, double row) const {
  const Eigen::Vector2d outwards = direction(column);
  return {radius_ * outwards.x(), radius_ * outwards.y(), bottom_ + row * row_height()};
}

std::array<Eigen::Vector3d, 4> Wall::corners(int tile) const {
  const int row = row_of(tile);
  const int column = column_of(tile);
  return {point(column + 1, row), point(column, row), point(column, row + 1), point(column + 1, row + 1)};
}

Eigen::Vector3d Wall::normal(int tile) const {
  const Eigen::Vector2d outwards = direction(column_of(tile) + 0.5);
  return {outwards.x(), outwards.y(), 0.0};
}

bool Wall::surrounds(const Eigen::Vector2d& position) const {
  return position.allFinite() && position.squaredNorm() < 0.999 * radius_ * radius_;
}

std::optional<WallPoint> Wall::meet(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
  std::optional<WallPoint> point;
  meet(from, {&direction, 1}, {&point, 1});
  return point;
}

void Wall::meet(const Eigen::Vector3d& from, std::span<const Eigen::Vector3d> directions,
                std::span<std::optional<WallPoint>> points) const {
  constexpr std::size_t kAtOnce = 16;
  std::array<double, kAtOnce> x, y, azimuths;
  const Eigen::Vector2d foot = from.head<2>();
  const bool is_inside = surrounds(foot);
  for (std::size_t first = 0; first < points.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, points.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d& direction = directions[first + i];
      const Eigen::Vector2d heading = direction.head<2>();
      std::optional<WallPoint>& point = points[first + i];
      point.reset();
      x[i] = y[i] = 0.0;
      if (!is_inside || !direction.allFinite() || heading.norm() <= kSteepest * direction.norm()) continue;
      const double steps = steps_to_circle(foot, heading, radius_);
      const Eigen::Vector2d place = foot + steps * heading;
      x[i] = place.x();
      y[i] = place.y();
      point = WallPoint{0.0, (from.z() + steps * direction.z() - bottom_) / row_height()};
    }
    pinned::atan2(std::span(y.data(), count), std::span(x.data(), count), std::span(azimuths.data(), count));
    for (std::size_t i = 0; i < count; ++i) {
      if (!points[first + i]) continue;
      points[first + i]->column = column_at(azimuths[i]);
    }
  }
}

std::optional<double> Wall::azimuth_seen(const Eigen::Vector2d& from, double direction) const {
  if (!surrounds(from) || !std::isfinite(direction)) return std::nullopt;
  const Eigen::Vector2d heading = unit_vector(direction);
  const Eigen::Vector2d point = from + steps_to_circle(from, heading, radius_) * heading;
  return normalize_angle(direction_of(point));
}

void Wall::azimuths_seen(const Eigen::Vector2d& from, std::span<const Eigen::Vector2d> headings,
                         std::span<double> azimuths) const {
  constexpr std::size_t kAtOnce = 16;
  std::array<double, kAtOnce> x, y;
  for (std::size_t first = 0; first < headings.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, headings.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector2d& heading = headings[first + i];
      const Eigen::Vector2d point = from + steps_to_circle(from, heading, radius_) * heading;
      x[i] = point.x();
      y[i] = point.y();
    }
    pinned::atan2(std::span(y.data(), count), std::span(x.data(), count), azimuths.subspan(first, count));
  }
  for (double& azimuth : azimuths) azimuth = normalize_angle(azimuth);
}

std::optional<double> view_center(const Wall& wall, const Pose2& belief, const Isometry3& robot_from_camera) {
  const Eigen::Vector3d axis = robot_from_camera.linear().col(0);
  if (!axis.allFinite() || axis.head<2>().norm() < kSteepest) return std::nullopt;
  const Eigen::Vector2d camera = belief * Eigen::Vector2d(robot_from_camera.translation().head<2>());
  return wall.azimuth_seen(camera, belief.rotation + direction_of(axis.head<2>()));
}

}  // namespace reorient
