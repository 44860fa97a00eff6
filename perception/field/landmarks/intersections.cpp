// SPDX-License-Identifier: MIT
#include "perception/field/landmarks/intersections.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/transform.h"
#include "perception/field/carpet/boundary.h"
#include "perception/field/lines/hiding.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostIntersections = 16;
constexpr double kSamePlace = 0.3;    // m, smallest distance between two intersections
constexpr double kRightAngle = 0.34;  // cosine of 70 degrees, the smallest angle between two lines that meet

Vector2d left_of(const Vector2d& direction) { return {-direction.y(), direction.x()}; }

}  // namespace

Intersections::Intersections(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), field_(field) {}

/// Whether a white stripe with the width of a line is here, at a right angle to `across` (unit vector). Hidden: the
/// position is outside of the image, behind an object, or too far away for a stripe to be visible.
Intersections::Stripe Intersections::stripe_at(const Frame& frame, const Vector2d& place,
                                               const Vector2d& across) const {
  constexpr double kLeastApart = 3.0, kMostApart = 5.0;  // pixels, line widths: from the line's middle to the carpet
  constexpr int kSteps = 4;                              // to each side, in the search for the middle of the line
  const auto pixel_at = [&](double offset) {
    const Vector2d point = place + offset * across;
    return frame.view.pixel({point.x(), point.y(), 0.0});
  };
  const auto middle = pixel_at(0.0);
  const auto beside = pixel_at(field_.line_width);
  if (!middle || !beside || hides(frame.percept, *middle)) return Stripe::hidden;
  const double width = (*beside - *middle).norm();  // pixels
  const double apart = std::max(1.7, kLeastApart / std::max(width, 1e-6));
  if (apart > kMostApart) return Stripe::hidden;
  const auto luma_at = [&](double offset) -> int {
    const Vector2d point = place + offset * field_.line_width * across;
    const auto pixel = frame.nearest_to_ground(point);
    if (!pixel) return -1;
    if (pixel->y() < boundary_at(frame.percept.boundary, frame.image.width, pixel->x())) return -1;
    return frame.at(*pixel).y;
  };
  const int left = luma_at(-apart - 0.5), right = luma_at(apart + 0.5);
  if (left < 0 || right < 0) return Stripe::hidden;
  int brightest = 0;
  for (int i = -kSteps; i <= kSteps; ++i) brightest = std::max(brightest, luma_at(0.8 * i / kSteps));
  const double least = std::max(0.7 * parameters_.line_contrast, parameters_.noise_factor * frame.color.noise());
  return brightest - std::max(left, right) > least ? Stripe::there : Stripe::not_there;
}

Intersections::Stripe Intersections::arm_at(const Frame& frame, const Vector2d& corner, const Vector2d& along) const {
  const double start = std::max(0.12, 2.0 * field_.line_width);
  constexpr double kStep = 0.06;  // m
  constexpr int kPlaces = 4;
  int there = 0, not_there = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const Stripe stripe = stripe_at(frame, corner + (start + i * kStep) * along, left_of(along));
    there += stripe == Stripe::there ? 1 : 0;
    not_there += stripe == Stripe::not_there ? 1 : 0;
  }
  if (there >= kPlaces - 1) return Stripe::there;
  return not_there >= kPlaces - 1 ? Stripe::not_there : Stripe::hidden;
}

/// Whether an arc connects the two lines, which go on behind it.
bool Intersections::has_corner_arc(const Frame& frame, const Vector2d& corner, double direction) const {
  if (field_.corner_arc_radius <= 0.0) return false;
  constexpr double kBehind = 1.3;  // multiple of the radius
  for (const double side : {-0.25 * kPi, 0.25 * kPi}) {
    const Vector2d line = unit_vector(direction + side);
    if (stripe_at(frame, corner + kBehind * field_.corner_arc_radius * line, left_of(line)) == Stripe::not_there)
      return false;
  }
  constexpr int kPlaces = 5, kMiddle = 2;
  int there = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const Vector2d out = unit_vector(direction + from_degrees(12.0) * (i - kMiddle));
    there += stripe_at(frame, corner + field_.corner_arc_radius * out, out) == Stripe::there ? 1 : 0;
  }
  return there >= kPlaces - 1;
}

Intersection Intersections::at(const Frame& frame, const Vector2d& position, IntersectionKind kind,
                               double direction) const {
  Intersection intersection;
  intersection.position = position;
  intersection.kind = kind;
  intersection.direction = normalize_angle(direction);
  const Vector2d pixel = frame.view.pixel({position.x(), position.y(), 0.0}).value_or(Vector2d::Zero());
  intersection.pixel = pixel.cast<float>();
  intersection.covariance =
      frame.view.covariance(position, parameters_.attitude_deviation, pixel, parameters_.pixel_deviation);
  intersection.corner_arc = kind == IntersectionKind::l && has_corner_arc(frame, position, direction);
  return intersection;
}

std::optional<Intersection> Intersections::meet(const Frame& frame, const LineSegment& a, const LineSegment& b) const {
  constexpr double kGap = 0.35;  // m between the end of a segment and its intersection with another one
  const double sine = cross(a.direction, b.direction);
  if (std::abs(a.direction.dot(b.direction)) > kRightAngle) return std::nullopt;
  const double along_a = cross(b.from - a.from, b.direction) / sine;
  const double along_b = cross(b.from - a.from, a.direction) / sine;
  if (along_a < -kGap || along_a > a.length + kGap || along_b < -kGap || along_b > b.length + kGap) return std::nullopt;
  const Vector2d corner = a.from + along_a * a.direction;
  if (frame.view.distance(corner) > parameters_.line_range) return std::nullopt;

  const std::array<Vector2d, 4> arms{a.direction, -a.direction, b.direction, -b.direction};
  std::array<bool, 4> there{};
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Stripe arm = arm_at(frame, corner, arms[i]);
    if (arm == Stripe::hidden) return std::nullopt;
    there[i] = arm == Stripe::there;
  }
  const int of_a = there[0] + there[1], of_b = there[2] + there[3];
  if (of_a == 0 || of_b == 0) return std::nullopt;
  const Vector2d arm_a = there[0] ? arms[0] : arms[1], arm_b = there[2] ? arms[2] : arms[3];
  if (of_a + of_b == 4) return at(frame, corner, IntersectionKind::x, direction_of(arm_a));
  if (of_a + of_b == 3) return at(frame, corner, IntersectionKind::t, direction_of(of_a == 1 ? arm_a : arm_b));
  return at(frame, corner, IntersectionKind::l, direction_of(arm_a + arm_b));
}

/// The halfway line crosses the circle at two points.
void Intersections::add_circle(const Frame& frame, FieldPercept& percept) const {
  if (!percept.center_circle || !percept.center_circle->halfway_direction) return;
  const CenterCircle& circle = *percept.center_circle;
  const double halfway = *circle.halfway_direction;
  for (const double side : {1.0, -1.0}) {
    const Vector2d out = side * unit_vector(halfway);
    const Vector2d place = circle.center + field_.center_circle_radius * out;
    if (frame.view.distance(place) > parameters_.line_range) continue;
    if (arm_at(frame, place, out) != Stripe::there || arm_at(frame, place, -out) != Stripe::there) continue;
    percept.intersections.push_back(at(frame, place, IntersectionKind::x, halfway));
  }
}

/// Follows the stripe from the end of its known piece until another line replaces it or it ends.
std::optional<Intersection> Intersections::at_end(const Frame& frame, const Vector2d& end, const Vector2d& out) const {
  constexpr double kStep = 0.04, kFarthest = 0.4, kFinest = 0.01;  // m
  for (const Intersection& one : frame.percept.intersections) {
    if ((one.position - end).norm() < kSamePlace) return std::nullopt;
  }
  const Vector2d across = left_of(out);
  double reached = 0.0;
  for (double step = kStep; step >= kFinest; step *= 0.5) {
    while (reached <= kFarthest && stripe_at(frame, end + (reached + step) * out, across) == Stripe::there)
      reached += step;
  }
  if (reached > kFarthest) return std::nullopt;
  const Vector2d corner = end + (reached + 0.5 * field_.line_width) * out;
  if (frame.view.distance(corner) > parameters_.line_range) return std::nullopt;
  if (arm_at(frame, corner, -out) != Stripe::there || arm_at(frame, corner, out) != Stripe::not_there)
    return std::nullopt;
  const Stripe left = arm_at(frame, corner, across), right = arm_at(frame, corner, -across);
  if (left == Stripe::hidden || right == Stripe::hidden) return std::nullopt;
  if (left == Stripe::there && right == Stripe::there)
    return at(frame, corner, IntersectionKind::t, direction_of(-out));
  if (left == Stripe::not_there && right == Stripe::not_there) return std::nullopt;
  return at(frame, corner, IntersectionKind::l, direction_of((left == Stripe::there ? across : -across) - out));
}

/// Straight lines never cross on a field. The arc at a corner of the field meets lines and bends, where no intersection
/// is.
void Intersections::add(const std::optional<Intersection>& found, FieldPercept& percept) const {
  constexpr double kOnArc = 0.12;  // m
  const auto is_on_arc = [this](const Intersection& one, const Intersection& corner) {
    return corner.corner_arc && !one.corner_arc &&
           std::abs((one.position - corner.position).norm() - field_.corner_arc_radius) < kOnArc;
  };
  if (!found || found->kind == IntersectionKind::x || percept.intersections.size() >= kMostIntersections) return;
  const bool is_known =
      std::any_of(percept.intersections.begin(), percept.intersections.end(), [&](const Intersection& one) {
        return (one.position - found->position).norm() < kSamePlace || is_on_arc(*found, one);
      });
  if (is_known) return;
  std::erase_if(percept.intersections, [&](const Intersection& one) { return is_on_arc(one, *found); });
  percept.intersections.push_back(*found);
}

void Intersections::find(const FieldImage& seen, std::span<const LineSegment> segments, FieldPercept& percept) const {
  percept.intersections.clear();
  const Frame frame{seen, percept};
  add_circle(frame, percept);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) add(meet(frame, segments[i], segments[j]), percept);
  }
  for (const LineSegment& segment : segments) {
    add(at_end(frame, segment.from, -segment.direction), percept);
    add(at_end(frame, segment.to, segment.direction), percept);
  }
}

}  // namespace reorient
