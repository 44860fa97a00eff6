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

constexpr double kFoot = 0.05;  // m above the ground, of a post or a robot
constexpr double kRim = 0.03;   // of the image's width, along its edges: objects there do not count

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
  /// The same for a point on the ground and a line; m, field frame.
  bool shows_line(const Vector2d& place) const { return shows(in_robot(place), 0.0, Label::line); }
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

std::vector<Thing> goal_posts_in_view(const Shot& shot, const FieldDimensions& field) {
  constexpr double kPostHeight = 0.5;
  std::vector<Thing> posts;
  for (const Vector2d& post : goal_posts(field)) {
    const Vector2d seen = shot.in_robot(post);
    posts.push_back({seen, shot.shows(seen, kFoot, Label::goal) && shot.shows(seen, kPostHeight, Label::goal)});
  }
  return posts;
}

std::vector<Thing> robots_in_view(const Shot& shot) {
  constexpr double kBeside = 0.35;  // m to the line of sight, within which a nearer robot hides another one
  std::vector<Thing> robots;
  for (const Player& player : shot.simulator.other_robots()) {
    const Vector2d middle = shot.in_robot(player.pose.position);
    const Vector2d front = middle - Players::kRadius * middle.normalized();
    robots.push_back({front, shot.shows(middle, kFoot, Label::robot) && shot.is_in_front(middle, kFoot)});
  }
  for (Thing& one : robots) {
    one.clearly = one.clearly && std::none_of(robots.begin(), robots.end(), [&](const Thing& other) {
                    const double aside = std::abs(cross(one.position.normalized(), other.position));
                    return other.position.norm() < one.position.norm() && one.position.dot(other.position) > 0.0 &&
                           aside < kBeside;
                  });
  }
  return robots;
}

/// Whether the image shows the middle of an intersection and the beginning of each arm.
bool shows_intersection(const Shot& shot, const FieldDimensions& field, const FieldIntersection& one) {
  constexpr double kArm = 0.3;  // m of each arm
  if (!shot.shows_line(one.position)) return false;
  const std::vector<Vector2d> arms = arms_of(one.kind, one.direction);
  return std::all_of(arms.begin(), arms.end(), [&](const Vector2d& arm) {
    const Vector2d end = one.position + kArm * arm;
    const bool is_of_circle = one.kind == IntersectionKind::x && std::abs(arm.y()) < 0.5;
    return shot.shows_line(is_of_circle ? Vector2d(field.center_circle_radius * end.normalized()) : end);
  });
}

std::vector<IntersectionInView> intersections_in_view(const Shot& shot, const FieldDimensions& field) {
  std::vector<IntersectionInView> intersections;
  for (const FieldIntersection& one : field_intersections(field)) {
    IntersectionInView intersection;
    intersection.position = shot.in_robot(one.position);
    intersection.kind = one.kind;
    intersection.direction = normalize_angle(one.direction - shot.robot.rotation);
    intersection.clearly = shows_intersection(shot, field, one);
    intersections.push_back(intersection);
  }
  return intersections;
}

std::vector<Thing> corner_arcs_in_view(const Shot& shot, const FieldDimensions& field) {
  constexpr int kPlaces = 5;
  std::vector<Thing> arcs;
  for (const CornerArc& arc : corner_arcs(field)) {
    bool clearly = shows_intersection(shot, field, {arc.corner, IntersectionKind::l, arc.begin + from_degrees(45.0)});
    for (int i = 0; i < kPlaces; ++i) {
      const double along = from_degrees(22.5 + 45.0 * i / (kPlaces - 1));
      clearly = clearly && shot.shows_line(arc.corner + field.corner_arc_radius * unit_vector(arc.begin + along));
    }
    arcs.push_back({shot.in_robot(arc.corner), clearly});
  }
  return arcs;
}

std::vector<Thing> penalty_marks_in_view(const Shot& shot, const FieldDimensions& field) {
  constexpr int kPlaces = 8;  // around a mark
  std::vector<Thing> marks;
  for (const Vector2d& mark : penalty_marks(field)) {
    const Vector2d seen = shot.in_robot(mark);
    bool clearly = shot.shows(seen, 0.0, Label::line);
    for (int i = 0; i < kPlaces; ++i) {
      const Vector2d beside = seen + field.penalty_mark_size * unit_vector(2.0 * kPi * i / kPlaces);
      clearly = clearly && shot.shows(beside, 0.0, Label::carpet);
    }
    marks.push_back({seen, clearly});
  }
  return marks;
}

std::optional<Thing> center_circle_in_view(const Shot& shot, const FieldDimensions& field) {
  constexpr int kPlaces = 36;
  if (!(field.center_circle_radius > 0.0)) return std::nullopt;
  int clear = 0;
  for (int i = 0; i < kPlaces; ++i)
    clear += shot.shows_line(field.center_circle_radius * unit_vector(2.0 * kPi * i / kPlaces)) ? 1 : 0;
  return Thing{shot.in_robot(Vector2d::Zero()), 3 * clear >= kPlaces};
}

Thing ball_in_view(const Shot& shot, const FieldDimensions& field) {
  constexpr double kShown = 0.7;  // of its radius, to all sides
  const Vector2d ball = shot.in_robot(shot.simulator.ball().position);
  const double radius = 0.5 * field.ball_diameter;
  const Vector2d aside = kShown * radius * Vector2d(-ball.y(), ball.x()).normalized();
  const bool whole = shot.shows(ball + aside, radius, Label::ball) && shot.shows(ball - aside, radius, Label::ball) &&
                     shot.shows(ball, (1.0 + kShown) * radius, Label::ball) &&
                     shot.shows(ball, (1.0 - kShown) * radius, Label::ball);
  return {ball, whole};
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
  const Pose2 robot = simulator.ground_truth().pose;
  const Shot shot{simulator, frame, simulator.field_from_camera().inverse() * to_isometry(robot), robot};
  FieldInView view;
  view.robot = robot;
  view.bottom_row = frame.image.height - 1;
  for (const Vector2d& place : line_places(field)) {
    if (shot.shows_line(place)) view.line_places.push_back({shot.in_robot(place), true});
  }
  view.goal_posts = goal_posts_in_view(shot, field);
  view.robots = robots_in_view(shot);
  view.intersections = intersections_in_view(shot, field);
  view.corner_arcs = corner_arcs_in_view(shot, field);
  view.penalty_marks = penalty_marks_in_view(shot, field);
  view.center_circle = center_circle_in_view(shot, field);
  view.ball = ball_in_view(shot, field);
  return view;
}

}  // namespace reorient
