// SPDX-License-Identifier: MIT
#include "perception/field/upright/ball_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/pinned_math.h"
#include "perception/field/lines/hiding.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr int kPlaces = 16;  // positions around a ball

/// Whether a line is in view inside of this circle. A ball hides the line behind it; a line that leads away from a
/// rotating camera is blurred to the width of a ball.
bool shows_line(const FieldPercept& percept, const Vector2d& center, double radius) {
  constexpr double kInside = 0.9;  // multiple of the radius
  const double reach = kInside * radius;
  return std::any_of(percept.line_points.begin(), percept.line_points.end(), [&](const LinePoint& point) {
    return (point.pixel.cast<double>() - center).squaredNorm() < reach * reach;
  });
}

}  // namespace

BallFinder::BallFinder(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), radius_(0.5 * field.ball_diameter) {}

/// The image of a ball whose center is at this pixel.
std::optional<BallFinder::Circle> BallFinder::circle_around(const GroundProjection& view,
                                                            const Vector2d& center) const {
  const auto place = view.at_height(center, radius_);
  if (!place) return std::nullopt;
  const double far = pinned::hypot(view.distance(*place), view.camera_height() - radius_);
  if (!(far > 2.0 * radius_)) return std::nullopt;
  return Circle{center, view.pixels_per_radian(center) * radius_ / far, 0.0};
}

/// The image of a ball whose lowest point is at this pixel.
std::optional<BallFinder::Circle> BallFinder::circle_above(const GroundProjection& view, double column,
                                                           double foot) const {
  auto circle = circle_around(view, {column, foot});
  for (int iteration = 0; circle && iteration < 2; ++iteration)
    circle = circle_around(view, {column, foot - circle->radius});
  return circle;
}

/// Combines two fractions: of the positions inside that are not carpet, and of the positions around that are carpet or
/// a line that passes behind the ball. A foot or a hand continues into its robot, and a corner of lines continues in
/// two directions. The blurred end of the center circle, seen from the side, is as wide as a ball, but the circle's
/// line covers it.
double BallFinder::likeness(const Frame& frame, const Circle& circle) const {
  constexpr double kInner = 0.4, kOuter = 0.78, kBeyond = 1.3;  // multiples of the radius
  constexpr double kBlur = 1.2;                                 // pixels
  constexpr double kLeastSure = 0.4, kLeastOffCircle = 0.2, kDark = 0.7;
  constexpr int kInside = 2 * kPlaces, kMostCarpetInside = 1;
  constexpr int kLeastCarpet = 7, kLeastOpen = 15, kMostInRow = 3;  // positions around; on the line in a row
  const auto pixel_at = [&](double radius, int place) {
    return Vector2d(circle.center + radius * directions_around<kPlaces>()[static_cast<std::size_t>(place)]);
  };
  struct Seen {
    Surface surface;
    int luma;
  };
  const auto seen_at = [&](const Vector2d& where) -> std::optional<Seen> {
    const auto pixel = frame.nearest(where);
    if (!pixel) return std::nullopt;
    return Seen{frame.surface(*pixel), frame.at(*pixel).y};
  };
  const auto line_at = [&](const Vector2d& where) -> std::optional<int> {
    const auto place = frame.view.ground(where);
    return place ? frame.lines.at(*place) : std::nullopt;
  };
  int bare = 0;  // most other objects are rejected here
  for (int i = 0; i < kPlaces; i += kPlaces / 4) {
    const auto seen = seen_at(pixel_at(kInner * circle.radius, i));
    if (!seen || (seen->surface == Surface::carpet && ++bare > 1)) return 0.0;
  }
  int carpet = 0, open = 0, luma = 0;
  std::optional<int> behind;  // the line behind the ball
  int last_on_line = -2, in_row = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const Vector2d pixel = pixel_at(kBeyond * circle.radius + kBlur, i);
    const auto seen = seen_at(pixel);
    if (!seen) return 0.0;
    if (seen->surface == Surface::carpet) {
      ++carpet;
      ++open;
      luma += seen->luma;
    } else if (const auto line = line_at(pixel); line && (!behind || *behind == *line)) {
      behind = line;
      ++open;
      in_row = last_on_line == i - 1 ? in_row + 1 : 1;
      last_on_line = i;
      if (in_row > kMostInRow) return 0.0;
    } else if (kPlaces - i + open <= kLeastOpen) {
      return 0.0;
    }
  }
  if (carpet < kLeastCarpet || open < kLeastOpen) return 0.0;
  // The dark patches of a ball can have the tint of dark carpet.
  const double dark = kDark * luma / carpet;
  const bool is_on_circle = behind == KnownLines::kCenterCircle;
  int carpet_inside = 0, sure = 0, off_circle = 0;
  for (const double radius : {kOuter, kInner}) {
    for (int i = 0; i < kPlaces; ++i) {
      const auto seen = seen_at(pixel_at(radius * std::max(0.0, circle.radius - 0.5), i));
      if (!seen) return 0.0;
      if (seen->surface == Surface::carpet && seen->luma > dark && ++carpet_inside > kMostCarpetInside) return 0.0;
      sure += seen->surface == Surface::other ? 1 : 0;
      if (!is_on_circle) continue;
      off_circle += line_at(pixel_at(radius * circle.radius, i)) != behind ? 1 : 0;
    }
  }
  if (sure < kLeastSure * kInside || (is_on_circle && off_circle < kLeastOffCircle * kInside)) return 0.0;
  return 0.5 * (kInside - carpet_inside) / kInside + 0.5 * carpet / kPlaces;
}

std::optional<Ball> BallFinder::find(const FieldImage& seen, const CarpetMap& map, const KnownLines& lines,
                                     const FieldPercept& percept) const {
  constexpr double kLeastHeight = 1.1;  // multiples of the radius, of cells without carpet in a column
  constexpr double kSmallest = 2.0;     // pixels, smallest radius
  constexpr double kStep = 0.3;         // fraction of the radius, step of the search for the center
  constexpr double kUnsure = 0.15;      // fraction of the radius, uncertainty of the center
  // Tolerance of the ball's size. The camera may be higher or point farther down than assumed, and a ball may be worn.
  constexpr std::array kSizes{1.0, 1.2, 1.4};
  if (radius_ <= 0.0) return std::nullopt;
  const GroundProjection& view = seen.view;
  const Frame frame{seen, lines};
  Circle best, tried;
  for (int column = 0; column < CarpetMap::kColumns; ++column) {
    const double x = map.column_pixel(column);
    const double border = percept.boundary[static_cast<std::size_t>(column)];
    int foot = -1;  // the lowest cell without carpet
    for (int row = map.rows() - 1; row >= map.first_cell() && map.row_pixel(row) >= border; --row) {
      if (map.at(column, row) != Surface::carpet) {
        if (foot < 0) foot = row;
        continue;
      }
      const int height = foot < 0 ? 0 : foot - row;
      const int from = foot;
      foot = -1;
      if (height < 2) continue;
      const auto circle = circle_above(view, x, map.row_pixel(from) + 0.5 * map.step());
      if (!circle || circle->radius < kSmallest || height * map.step() < kLeastHeight * circle->radius) continue;
      const auto place = view.at_height(circle->center, radius_);
      if (!place || view.distance(*place) > parameters_.line_range) continue;
      if ((circle->center - tried.center).cwiseAbs().maxCoeff() < kStep * circle->radius) continue;
      tried = *circle;
      for (const double size : kSizes) {
        const double radius = size * circle->radius;
        const Vector2d center = circle->center + Vector2d(0.0, circle->radius - radius);
        for (int i = -2; i <= 2; ++i) {
          for (int j = -1; j <= 2; ++j) {
            Circle moved{center + kStep * radius * Vector2d(i, j), radius, 0.0};
            if (hides(percept, moved.center)) continue;  // a foot or a hand of a robot is round and white, too
            moved.likeness = likeness(frame, moved);
            if (moved.likeness > best.likeness && !shows_line(percept, moved.center, radius)) best = moved;
          }
        }
      }
    }
  }
  if (best.likeness <= 0.0) return std::nullopt;
  const auto place = view.at_height(best.center, radius_);
  if (!place) return std::nullopt;
  Ball ball;
  ball.position = *place;
  ball.pixel = best.center.cast<float>();
  ball.radius = static_cast<float>(best.radius);
  ball.covariance = view.covariance(*place, parameters_.attitude_deviation, best.center,
                                    parameters_.pixel_deviation + kUnsure * best.radius);
  return ball;
}

}  // namespace reorient
