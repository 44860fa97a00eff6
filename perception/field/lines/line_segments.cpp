// SPDX-License-Identifier: MIT
#include "perception/field/lines/line_segments.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostSegments = 24;
constexpr std::size_t kFewestOfSegment = 4;
constexpr double kShortest = 0.3;    // m
constexpr double kParallel = 0.906;  // cosine of 25 degrees

struct Line {
  Vector2d middle, direction;
};

}  // namespace

bool is_on_circle(const LinePoint& point, const Vector2d& center, double radius) {
  const Vector2d out = point.position - center;
  const double norm = out.norm();
  const double tolerance = 0.05 + 0.025 * point.position.norm();
  return norm > 0.0 && std::abs(norm - radius) < tolerance &&
         std::abs(out.dot(unit_vector(point.normal))) > kParallel * norm;
}

LineSegments::LineSegments() {
  segments_.reserve(kMostSegments);
  used_.reserve(1024);
  on_line_.reserve(1024);
}

std::span<const LineSegments::Along> LineSegments::run_around_seed() {
  constexpr double kGap = 0.45;  // m
  std::sort(on_line_.begin(), on_line_.end(), [](const Along& a, const Along& b) {
    return a.place < b.place || (a.place == b.place && a.point < b.point);
  });
  const auto seed = std::find_if(on_line_.begin(), on_line_.end(), [](const Along& one) { return one.place >= 0.0; });
  auto first = seed, last = seed;
  while (first != on_line_.begin() && first->place - (first - 1)->place < kGap) --first;
  while (last + 1 != on_line_.end() && (last + 1)->place - last->place < kGap) ++last;
  return {first, last + 1};
}

std::span<const LineSegment> LineSegments::find(std::span<const LinePoint> points,
                                                const std::optional<CenterCircle>& circle, double circle_radius) {
  segments_.clear();
  used_.assign(points.size(), false);
  if (circle) {
    for (std::size_t i = 0; i < points.size(); ++i) used_[i] = is_on_circle(points[i], circle->center, circle_radius);
  }
  for (std::size_t seed = 0; seed < points.size() && segments_.size() < kMostSegments; ++seed) {
    if (used_[seed]) continue;
    const Vector2d normal = unit_vector(points[seed].normal);
    Line line{points[seed].position, {-normal.y(), normal.x()}};
    std::span<const Along> run;
    for (const double width : {2.0, 1.0}) {
      on_line_.clear();
      const Vector2d start = points[seed].position;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (used_[i]) continue;
        const Vector2d offset = points[i].position - line.middle;
        if (i != seed && std::abs(cross(line.direction, offset)) > width * (0.025 + 0.012 * points[i].position.norm()))
          continue;
        if (i != seed && std::abs(cross(line.direction, unit_vector(points[i].normal))) < kParallel) continue;
        on_line_.push_back({(points[i].position - start).dot(line.direction), i});
      }
      run = run_around_seed();
      if (run.size() < kFewestOfSegment) break;
      Vector2d sum = Vector2d::Zero();
      Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
      for (const Along& one : run) {
        const Vector2d offset = points[one.point].position - start;
        sum += offset;
        squares += offset * offset.transpose();
      }
      const auto count = static_cast<double>(run.size());
      const Eigen::Matrix2d spread = squares / count - sum * sum.transpose() / (count * count);
      const double angle = 0.5 * pinned::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
      line = {start + sum / count, unit_vector(angle)};
    }
    const double length = run.empty() ? 0.0 : run.back().place - run.front().place;
    used_[seed] = true;
    if (run.size() < kFewestOfSegment || length < kShortest) continue;
    double least = 0.0, most = 0.0;
    for (const Along& one : run) {
      used_[one.point] = true;
      const double place = (points[one.point].position - line.middle).dot(line.direction);
      least = std::min(least, place);
      most = std::max(most, place);
    }
    segments_.push_back({line.middle + least * line.direction, line.middle + most * line.direction, line.direction,
                         most - least, static_cast<int>(run.size())});
  }
  return segments_;
}

}  // namespace reorient
