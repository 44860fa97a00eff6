// SPDX-License-Identifier: MIT
#include "workbench/simulated_images/in_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/transform.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr double kRim = 0.03;  // of the image's width, along its edges: objects there do not count

struct Shot {
  const Simulator& simulator;
  const CameraFrame& frame;
  Isometry3 camera_from_robot;
  Pose2 robot;

  Vector2d in_robot(const Vector2d& place) const { return robot.inverse() * place; }

  std::optional<Vector2d> pixel(const Vector2d& place, double height) const {
    auto seen = frame.camera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), height));
    const double rim = kRim * frame.image.width;
    if (!seen || seen->x() < rim || seen->y() < rim || seen->x() > frame.image.width - 1 - rim ||
        seen->y() > frame.image.height - 1 - rim) {
      return std::nullopt;
    }
    return seen;
  }
  /// Index of a pixel in the labels and the depths.
  std::size_t index_of(const Vector2d& seen) const {
    return static_cast<std::size_t>(std::lround(seen.y()) * frame.image.width + std::lround(seen.x()));
  }
  /// Whether no object that is nearer by half a meter hides it.
  bool is_in_front(const Vector2d& place, double height) const {
    constexpr double kBehind = 0.5;  // m
    const auto seen = pixel(place, height);
    if (!seen) return false;
    const Eigen::Vector3d point = camera_from_robot * Eigen::Vector3d(place.x(), place.y(), height);
    const double far = frame.camera.is_perspective() ? point.x() : point.norm();
    return simulator.depth()[index_of(*seen)] > far - kBehind;
  }
  /// Whether the image shows the label at a point (m, robot frame).
  bool shows(const Vector2d& place, double height, Label label) const {
    const auto seen = pixel(place, height);
    return seen && simulator.labels()[index_of(*seen)] == label;
  }
};

/// Unit vectors along the arms of an intersection.
std::vector<Vector2d> arms_of(IntersectionKind kind, double direction) {
  const auto turned = [&](double degrees) { return unit_vector(direction + from_degrees(degrees)); };
  switch (kind) {
    case IntersectionKind::l:
      return {turned(45.0), turned(-45.0)};
    case IntersectionKind::t:
      return {turned(0.0), turned(90.0), turned(-90.0)};
    case IntersectionKind::x:
      return {turned(0.0), turned(90.0), turned(180.0), turned(-90.0)};
  }
  return {};
}

std::vector<Vector2d> line_places(const FieldDimensions& field) {
  constexpr double kStep = 0.1;  // m
  std::vector<Vector2d> places;
  for (const FieldLine& line : field_lines(field)) {
    const double length = (line.to - line.from).norm();
    const int steps = std::max(1, static_cast<int>(std::lround(length / kStep)));
    for (int i = 0; i <= steps; ++i)
      places.emplace_back(line.from + (line.to - line.from) * (static_cast<double>(i) / steps));
  }
  const auto add_arc = [&](const Vector2d& center, double radius, double from, double turn) {
    if (radius <= 0.0) return;
    const int steps = std::max(1, static_cast<int>(std::lround(radius * std::abs(turn) / kStep)));
    for (int i = 0; i <= steps; ++i) places.emplace_back(center + radius * unit_vector(from + turn * i / steps));
  };
  add_arc(Vector2d::Zero(), field.center_circle_radius, 0.0, 2.0 * kPi);
  for (const CornerArc& arc : corner_arcs(field)) add_arc(arc.corner, field.corner_arc_radius, arc.begin, 0.5 * kPi);
  return places;
}

}  // namespace

LineNearby nearest_line_of(const FieldDimensions& field, const Vector2d& place) {
  LineNearby nearest{std::numeric_limits<double>::infinity(), 0.0};
  const auto consider = [&](double distance, double normal) {
    if (distance < nearest.distance) nearest = {distance, normal};
  };
  for (const FieldLine& line : field_lines(field)) {
    const Vector2d along = line.to - line.from;
    const double share = std::clamp((place - line.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    consider((place - line.from - share * along).norm(), direction_of({-along.y(), along.x()}));
  }
  if (field.center_circle_radius > 0.0)
    consider(std::abs(place.norm() - field.center_circle_radius), direction_of(place));
  const Vector2d half = field_half_size(field);
  const Vector2d corner(std::copysign(half.x(), place.x()), std::copysign(half.y(), place.y()));
  const Vector2d out = place - corner;
  const bool inside = std::abs(place.x()) <= std::abs(corner.x()) && std::abs(place.y()) <= std::abs(corner.y());
  if (field.corner_arc_radius > 0.0 && inside)
    consider(std::abs(out.norm() - field.corner_arc_radius), direction_of(out));
  return nearest;
}

FieldInView field_in_view(const Simulator& simulator, const CameraFrame& frame, const FieldDimensions& field) {
  constexpr double kArm = 0.3;  // m of each arm of an intersection that must be in view
  constexpr double kPostHeight = 0.5;
  constexpr double kFoot = 0.05;
  constexpr double kBeside = 0.35;  // m to the line of sight, within which a nearer robot hides another one
  constexpr int kCirclePlaces = 36, kMarkPlaces = 8, kArcPlaces = 5;
  constexpr double kBallShown = 0.7;  // of its radius, to all sides
  const Pose2 robot = simulator.ground_truth().pose;
  const Shot shot{simulator, frame, simulator.field_from_camera().inverse() * to_isometry(robot), robot};
  FieldInView view;
  view.robot = robot;
  view.bottom_row = frame.image.height - 1;
  for (const Vector2d& place : line_places(field)) {
    const Vector2d seen = shot.in_robot(place);
    if (shot.shows(seen, 0.0, Label::line)) view.line_places.push_back({seen, true});
  }
  for (const Vector2d& post : goal_posts(field)) {
    const Vector2d seen = shot.in_robot(post);
    view.goal_posts.push_back(
        {seen, shot.shows(seen, kFoot, Label::goal) && shot.shows(seen, kPostHeight, Label::goal)});
  }
  for (const Player& player : simulator.other_robots()) {
    const Vector2d middle = shot.in_robot(player.pose.position);
    const Vector2d front = middle - Players::kRadius * middle.normalized();
    view.robots.push_back({front, shot.shows(middle, kFoot, Label::robot) && shot.is_in_front(middle, kFoot)});
  }
  for (Thing& one : view.robots) {
    one.clearly = one.clearly && std::none_of(view.robots.begin(), view.robots.end(), [&](const Thing& other) {
                    const double aside = std::abs(cross(one.position.normalized(), other.position));
                    return other.position.norm() < one.position.norm() && one.position.dot(other.position) > 0.0 &&
                           aside < kBeside;
                  });
  }
  for (const FieldIntersection& one : field_intersections(field)) {
    IntersectionInView intersection;
    intersection.position = shot.in_robot(one.position);
    intersection.kind = one.kind;
    intersection.direction = normalize_angle(one.direction - robot.rotation);
    intersection.clearly = shot.shows(intersection.position, 0.0, Label::line);
    for (const Vector2d& arm : arms_of(one.kind, one.direction)) {
      Vector2d end = one.position + kArm * arm;
      // Follows the circle instead of a straight line.
      if (one.kind == IntersectionKind::x && std::abs(arm.y()) < 0.5)
        end = field.center_circle_radius * end.normalized();
      intersection.clearly = intersection.clearly && shot.shows(shot.in_robot(end), 0.0, Label::line);
    }
    view.intersections.push_back(intersection);
  }
  for (const CornerArc& arc : corner_arcs(field)) {
    const auto shows_line = [&](const Vector2d& from_corner) {
      return shot.shows(shot.in_robot(arc.corner + from_corner), 0.0, Label::line);
    };
    bool clearly = shows_line(Vector2d::Zero());
    for (const double degrees : {0.0, 90.0})
      clearly = clearly && shows_line(kArm * unit_vector(arc.begin + from_degrees(degrees)));
    for (int i = 0; i < kArcPlaces; ++i) {
      const double along = from_degrees(22.5 + 45.0 * i / (kArcPlaces - 1));
      clearly = clearly && shows_line(field.corner_arc_radius * unit_vector(arc.begin + along));
    }
    view.corner_arcs.push_back({shot.in_robot(arc.corner), clearly});
  }
  for (const Vector2d& mark : penalty_marks(field)) {
    const Vector2d seen = shot.in_robot(mark);
    bool clearly = shot.shows(seen, 0.0, Label::line);
    for (int i = 0; i < kMarkPlaces; ++i) {
      const Vector2d beside = seen + field.penalty_mark_size * unit_vector(2.0 * kPi * i / kMarkPlaces);
      clearly = clearly && shot.shows(beside, 0.0, Label::carpet);
    }
    view.penalty_marks.push_back({seen, clearly});
  }
  if (field.center_circle_radius > 0.0) {
    int clear = 0;
    for (int i = 0; i < kCirclePlaces; ++i) {
      const Vector2d place = field.center_circle_radius * unit_vector(2.0 * kPi * i / kCirclePlaces);
      clear += shot.shows(shot.in_robot(place), 0.0, Label::line) ? 1 : 0;
    }
    view.center_circle = Thing{shot.in_robot(Vector2d::Zero()), 3 * clear >= kCirclePlaces};
  }
  const Vector2d ball = shot.in_robot(simulator.ball().position);
  const double radius = 0.5 * field.ball_diameter;
  const Vector2d aside = kBallShown * radius * Vector2d(-ball.y(), ball.x()).normalized();
  const bool whole = shot.shows(ball + aside, radius, Label::ball) && shot.shows(ball - aside, radius, Label::ball) &&
                     shot.shows(ball, (1.0 + kBallShown) * radius, Label::ball) &&
                     shot.shows(ball, (1.0 - kBallShown) * radius, Label::ball);
  view.ball = Thing{ball, whole};
  return view;
}

}  // namespace reorient
