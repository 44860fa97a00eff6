// SPDX-License-Identifier: MIT
#include "perception/field/landmarks/center_circle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "geometry/transform.h"
#include "perception/field/lines/line_segments.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostVoters = 64;
constexpr int kFewestPoints = 8;

/// Whether the line through the point goes through the center.
bool is_radial(const LinePoint& point, const Vector2d& center) {
  return std::abs(unit_vector(point.normal).dot(center - point.position)) < 0.08 + 0.02 * point.position.norm();
}

}  // namespace

CenterCircleFinder::CenterCircleFinder(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), radius_(field.center_circle_radius) {
  votes_.reserve(2 * kMostVoters);
}

/// Each point votes for two centers, at the circle's radius on either side of it. The votes of points on a straight
/// line are far apart.
std::optional<Vector2d> CenterCircleFinder::vote(std::span<const LinePoint> points) {
  constexpr double kNear = 0.2;  // m
  votes_.clear();
  const std::size_t step = (points.size() + kMostVoters - 1) / kMostVoters;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vector2d normal = unit_vector(points[i].normal);
    votes_.emplace_back(points[i].position + radius_ * normal);
    votes_.emplace_back(points[i].position - radius_ * normal);
  }
  int most = 0;
  Vector2d center = Vector2d::Zero();
  for (const Vector2d& one : votes_) {
    int count = 0;
    Vector2d sum = Vector2d::Zero();
    for (const Vector2d& other : votes_) {
      const Vector2d offset = other - one;
      if (offset.squaredNorm() > kNear * kNear) continue;
      ++count;
      sum += offset;
    }
    if (count <= most) continue;
    most = count;
    center = one + sum / count;
  }
  if (most < std::min<int>(kFewestPoints, static_cast<int>(votes_.size()) / 4)) return std::nullopt;
  return center;
}

std::optional<CenterCircle> CenterCircleFinder::find(std::span<const LinePoint> points, const GroundProjection& view) {
  constexpr int kIterations = 4;
  constexpr int kBins = 24, kFewestBins = 5;  // of the circle
  constexpr double kContradiction = 0.35;     // points beside the circle's line for each point on it
  if (radius_ <= 0.0 || points.size() < kFewestPoints) return std::nullopt;
  std::optional<Vector2d> center = vote(points);
  if (!center) return std::nullopt;

  // Least squares of the distances to the circle's line.
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    information.setZero();
    Vector2d pull = Vector2d::Zero();
    int count = 0;
    for (const LinePoint& point : points) {
      if (!is_on_circle(point, *center, radius_)) continue;
      const Vector2d out = point.position - *center;
      const double norm = out.norm();
      const double deviation = 0.02 + 0.02 * point.position.norm();  // m
      const double weight = 1.0 / (deviation * deviation);
      const Vector2d radial = out / norm;
      information += weight * radial * radial.transpose();
      pull += weight * (norm - radius_) * radial;
      ++count;
    }
    if (count < kFewestPoints || !(information.determinant() > 1e-6 * information.squaredNorm())) return std::nullopt;
    *center += information.inverse() * pull;
  }

  std::uint32_t bins = 0;
  int on_circle = 0, beside = 0;
  for (const LinePoint& point : points) {
    const Vector2d out = point.position - *center;
    if (is_on_circle(point, *center, radius_)) {
      const double fraction = direction_of(out) / (2.0 * kPi) + 0.5;
      bins |= 1u << std::clamp(static_cast<int>(fraction * kBins), 0, kBins - 1);
      ++on_circle;
    } else if (out.norm() > 0.5 * radius_ && out.norm() < 1.5 * radius_ && !is_radial(point, *center)) {
      ++beside;
    }
  }
  if (on_circle < kFewestPoints || std::popcount(bins) < kFewestBins || beside > kContradiction * on_circle)
    return std::nullopt;

  // Neighboring points have common errors.
  constexpr double kIndependent = 8.0;
  const double shared = std::max(1.0, on_circle / kIndependent);
  CenterCircle circle;
  circle.center = *center;
  circle.covariance = shared * information.inverse() + view.covariance(*center, parameters_.attitude_deviation);
  find_halfway_line(points, circle);
  return circle;
}

void CenterCircleFinder::find_halfway_line(std::span<const LinePoint> points, CenterCircle& circle) const {
  constexpr double kNearest = 0.25;  // m from the center, where the direction of a point is significant
  constexpr int kFewest = 4;
  constexpr double kAgreement = 0.97;
  Vector2d sum = Vector2d::Zero();  // of doubled angles, weighted by the distance
  double weights = 0.0, moment = 0.0;
  int count = 0;
  for (const LinePoint& point : points) {
    const Vector2d out = point.position - circle.center;
    const double norm = out.norm();
    if (norm < kNearest || is_on_circle(point, circle.center, radius_) || !is_radial(point, circle.center)) continue;
    // (cos 2a, sin 2a) of the direction a.
    const double across = norm * norm;
    sum += Vector2d(out.x() * out.x() - out.y() * out.y(), 2.0 * out.x() * out.y()) / across * norm;
    weights += norm;
    moment += across;
    ++count;
  }
  if (count < kFewest || sum.norm() < kAgreement * weights) return;
  const double deviation = 0.02 + 0.02 * circle.center.norm();  // m, standard deviation of a point across the line
  circle.halfway_direction = 0.5 * direction_of(sum);
  circle.direction_variance = deviation * deviation / std::max(moment / count, 1e-6) +
                              parameters_.attitude_deviation * parameters_.attitude_deviation;
}

}  // namespace reorient
