// SPDX-License-Identifier: MIT
#include "workbench/simulated_images/percept_score.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include "geometry/angle.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr double kTwisted = from_degrees(20.0);      // of an intersection with a wrong direction
constexpr double kTwistedLine = from_degrees(10.0);  // of a line point

/// Largest error of a percept, m: a constant part and a part proportional to the distance.
struct Tolerance {
  double fixed, share;
  double at(double distance) const { return fixed + share * distance; }
};
constexpr Tolerance kLine{0.05, 0.03}, kPost{0.05, 0.15}, kLandmark{0.1, 0.1}, kRobot{0.3, 0.1};
constexpr double kLineFound = 0.25;  // m from a place on a line to the next line point

/// m
double range_of(PerceptKind kind, const FieldFeatureParameters& parameters) {
  if (kind == PerceptKind::goal_posts) return parameters.post_range;
  return kind == PerceptKind::obstacles ? parameters.obstacle_range : parameters.line_range;
}

struct Counter {
  PerceptScore& score;
  PerceptKind kind;
  double farthest;

  PerceptCounts* at(const Vector2d& position) const {
    const double distance = position.norm();
    for (std::size_t band = 0; band < PerceptScore::kBands.size(); ++band) {
      if (distance <= PerceptScore::kBands[band]) return &score.counts[static_cast<std::size_t>(kind)][band];
    }
    return nullptr;
  }
  void ask(const Vector2d& position, bool found) const {
    PerceptCounts* const counts = at(position);
    if (counts == nullptr || position.norm() > farthest) return;
    ++counts->in_view;
    counts->found += found ? 1 : 0;
  }
  /// `truth`: the object of the percept; nothing: it is false.
  void report(const Vector2d& position, const std::optional<Vector2d>& truth,
              const Eigen::Matrix2d* covariance = nullptr) const {
    PerceptCounts* const counts = at(position);
    if (counts == nullptr) return;
    ++counts->reported;
    if (!truth) return;
    ++counts->right;
    counts->bearing_error += std::abs(angle_difference(direction_of(position), direction_of(*truth)));
    counts->distance_error += std::abs(position.norm() / truth->norm() - 1.0);
    if (covariance == nullptr) return;
    const Vector2d error = position - *truth;
    ++counts->with_covariance;
    counts->squared_error += error.dot(covariance->inverse() * error);
  }
};

/// The nearest fitting one of `things` within the tolerance.
template <typename T, typename Fits>
const T* nearest_of(const std::vector<T>& things, const Vector2d& position, const Tolerance& tolerance, Fits&& fits) {
  const T* nearest = nullptr;
  for (const T& thing : things) {
    const double distance = (thing.position - position).norm();
    if (distance > tolerance.at(thing.position.norm()) || !fits(thing)) continue;
    if (nearest == nullptr || distance < (nearest->position - position).norm()) nearest = &thing;
  }
  return nearest;
}

std::optional<Vector2d> position_of(const Thing* thing) {
  return thing != nullptr ? std::optional(thing->position) : std::nullopt;
}

bool is_same(const Intersection& seen, const IntersectionInView& there) {
  if (seen.kind != there.kind) return false;
  const double turned = angle_difference(seen.direction, there.direction);
  return std::abs(seen.kind == IntersectionKind::x ? std::remainder(turned, 0.5 * kPi) : turned) < kTwisted;
}

/// Scores percepts with a position.
template <typename P, typename T, typename Fits>
void count(const Counter& counter, const std::vector<P>& percepts, const std::vector<T>& things,
           const Tolerance& tolerance, Fits&& fits) {
  for (const P& percept : percepts) {
    const T* const thing =
        nearest_of(things, percept.position, tolerance, [&](const T& one) { return fits(percept, one); });
    if constexpr (requires { percept.covariance; }) {
      counter.report(percept.position, position_of(thing), &percept.covariance);
    } else {
      counter.report(percept.position, position_of(thing));
    }
  }
  for (const T& thing : things) {
    if (!thing.clearly) continue;
    counter.ask(thing.position, std::any_of(percepts.begin(), percepts.end(), [&](const P& percept) {
                  return (percept.position - thing.position).norm() <= tolerance.at(thing.position.norm()) &&
                         fits(percept, thing);
                }));
  }
}

void count_lines(const Counter& counter, const FieldPercept& percept, const FieldInView& view,
                 const FieldDimensions& field) {
  for (const LinePoint& point : percept.line_points) {
    const LineNearby line = nearest_line_of(field, view.robot * point.position);
    const bool right = line.distance <= kLine.at(point.position.norm());
    counter.report(point.position, right ? std::optional(point.position) : std::nullopt);
    const double turned = std::remainder(point.normal + view.robot.rotation - line.normal, kPi);
    if (PerceptCounts* const counts = counter.at(point.position))
      counts->twisted += std::abs(turned) > kTwistedLine ? 1 : 0;
  }
  for (const Thing& place : view.line_places) {
    counter.ask(place.position,
                std::any_of(percept.line_points.begin(), percept.line_points.end(), [&](const LinePoint& point) {
                  return (point.position - place.position).norm() <= kLineFound;
                }));
  }
}

/// Only the direction is known of an object that is so near that its foot is below the image.
void count_obstacles(const Counter& counter, const std::vector<Obstacle>& percepts, const std::vector<Thing>& things,
                     int bottom_row) {
  constexpr double kFootNotInView = 1.2;  // m; the image shows the ground before a foot that is farther away
  std::vector<Obstacle> moved = percepts;
  for (Obstacle& obstacle : moved) {
    if (obstacle.bottom < bottom_row) continue;
    for (const Thing& thing : things) {
      const double across = std::abs(cross(obstacle.position.normalized(), thing.position));
      if (thing.position.norm() > kFootNotInView || across > kRobot.fixed) continue;
      if (obstacle.position.dot(thing.position) > 0.0) obstacle.position = thing.position;
    }
  }
  count(counter, moved, things, kRobot, [](const auto&, const auto&) { return true; });
}

/// Points along the posts and the net's frame, field frame: obstacles there are right.
std::vector<Vector2d> frame_of_goals(const FieldDimensions& field) {
  constexpr int kSteps = 4;
  std::vector<Vector2d> places;
  for (const Vector2d& post : goal_posts(field)) {
    const Vector2d back(post.x() + std::copysign(field.goal_depth, post.x()), post.y());
    for (int i = 0; i <= kSteps; ++i) {
      places.emplace_back(post + (back - post) * (static_cast<double>(i) / kSteps));
      places.emplace_back(back.x(), back.y() * (1.0 - static_cast<double>(i) / kSteps));
    }
  }
  return places;
}

struct Placed {
  Vector2d position;
  Eigen::Matrix2d covariance;
};

}  // namespace

PerceptCounts operator+(const PerceptCounts& a, const PerceptCounts& b) {
  return {a.in_view + b.in_view,
          a.found + b.found,
          a.reported + b.reported,
          a.right + b.right,
          a.twisted + b.twisted,
          a.bearing_error + b.bearing_error,
          a.distance_error + b.distance_error,
          a.with_covariance + b.with_covariance,
          a.squared_error + b.squared_error};
}

PerceptScore operator+(const PerceptScore& a, const PerceptScore& b) {
  PerceptScore sum = a;
  sum.images += b.images;
  for (std::size_t kind = 0; kind < kPerceptKinds.size(); ++kind) {
    for (std::size_t band = 0; band < PerceptScore::kBands.size(); ++band)
      sum.counts[kind][band] = a.counts[kind][band] + b.counts[kind][band];
  }
  return sum;
}

PerceptCounts PerceptScore::between(PerceptKind kind, double least, double most) const {
  PerceptCounts sum;
  for (std::size_t band = 0; band < kBands.size(); ++band) {
    if (kBands[band] > least && kBands[band] <= most) sum = sum + counts[static_cast<std::size_t>(kind)][band];
  }
  return sum;
}

PerceptScore score_of(const FieldPercept& percept, const FieldInView& view, const FieldDimensions& field,
                      const FieldFeatureParameters& parameters) {
  PerceptScore score;
  score.images = 1;
  const auto counter = [&](PerceptKind kind) { return Counter{score, kind, range_of(kind, parameters)}; };
  const auto any = [](const auto&, const auto&) { return true; };
  count_lines(counter(PerceptKind::line_points), percept, view, field);
  count(counter(PerceptKind::goal_posts), percept.goal_posts, view.goal_posts, kPost, any);
  count(counter(PerceptKind::intersections), percept.intersections, view.intersections, kLandmark, is_same);
  std::vector<Intersection> corners;
  std::copy_if(percept.intersections.begin(), percept.intersections.end(), std::back_inserter(corners),
               [](const Intersection& one) { return one.corner_arc; });
  count(counter(PerceptKind::corner_arcs), corners, view.corner_arcs, kLandmark, any);
  count(counter(PerceptKind::penalty_marks), percept.penalty_marks, view.penalty_marks, kLandmark, any);
  std::vector<Thing> obstacles = view.robots;
  for (const Vector2d& place : frame_of_goals(field)) obstacles.push_back({view.robot.inverse() * place, false});
  count_obstacles(counter(PerceptKind::obstacles), percept.obstacles, obstacles, view.bottom_row);
  std::vector<Placed> circles, balls;
  std::vector<Thing> real_circles, real_balls;
  if (percept.center_circle) circles.push_back({percept.center_circle->center, percept.center_circle->covariance});
  if (percept.ball) balls.push_back({percept.ball->position, percept.ball->covariance});
  if (view.center_circle) real_circles.push_back(*view.center_circle);
  if (view.ball) real_balls.push_back(*view.ball);
  count(counter(PerceptKind::center_circle), circles, real_circles, kLandmark, any);
  count(counter(PerceptKind::ball), balls, real_balls, kLandmark, any);
  return score;
}

}  // namespace reorient
