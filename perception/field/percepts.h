// SPDX-License-Identifier: MIT
// The features of the field in one image. Positions are on the ground in the robot frame: m, x forward, y left.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/const_or.h"
#include "geometry/field_landmarks.h"

namespace reorient {

/// A point on the center of a field line.
struct LinePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
  double normal = 0.0;  ///< direction across the line, rad; opposite directions are equivalent: in (-pi/2, pi/2]
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
};

template <typename Visit, ConstOr<LinePoint> T>
void fields(Visit&& visit, T& point) {
  visit(point.position, point.normal, point.pixel);
}

struct GoalPost {
  /// m, position of the post on the ground; from the base, or from the height if the base is not in view
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  bool base_visible = true;                        ///< false: the bearing is accurate, the distance is rough
  Eigen::Vector2f base = Eigen::Vector2f::Zero();  ///< pixel
  Eigen::Vector2f top = Eigen::Vector2f::Zero();   ///< pixel, the highest point that was found
};

template <typename Visit, ConstOr<GoalPost> T>
void fields(Visit&& visit, T& post) {
  visit(post.position, post.base_visible, post.base, post.top);
}

/// An object that stands on the field and hides the background: a robot, a person, the neighbor of a post.
struct Obstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m, nearest point on the ground
  int left = 0;                                        ///< first and last image column that it covers
  int right = 0;
  int top = 0;  ///< image rows
  int bottom = 0;
};

template <typename Visit, ConstOr<Obstacle> T>
void fields(Visit&& visit, T& obstacle) {
  visit(obstacle.position, obstacle.left, obstacle.right, obstacle.top, obstacle.bottom);
}

/// The center circle, of whose line at least a part is in view.
struct CenterCircle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();          ///< m
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< of the center, m^2
  /// rad, direction of the halfway line; opposite directions are equivalent: in (-pi/2, pi/2]. Empty if the line was
  /// not seen.
  std::optional<double> halfway_direction;
  double direction_variance = 0.0;  ///< rad^2
};

template <typename Visit, ConstOr<CenterCircle> T>
void fields(Visit&& visit, T& circle) {
  visit(circle.center, circle.covariance, circle.halfway_direction, circle.direction_variance);
}

/// A point where two lines meet.
struct Intersection {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();        ///< m
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< m^2
  IntersectionKind kind = IntersectionKind::l;
  double direction = 0.0;   ///< rad, as in FieldIntersection
  bool corner_arc = false;  ///< whether an L has a quarter circle around it, so it is a corner of the field
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
};

template <typename Visit, ConstOr<Intersection> T>
void fields(Visit&& visit, T& intersection) {
  visit(intersection.position, intersection.covariance, intersection.kind, intersection.direction,
        intersection.corner_arc, intersection.pixel);
}

struct PenaltyMark {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();        ///< m
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< m^2
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
};

template <typename Visit, ConstOr<PenaltyMark> T>
void fields(Visit&& visit, T& mark) {
  visit(mark.position, mark.covariance, mark.pixel);
}

struct Ball {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();        ///< m, point of contact with the ground
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< m^2
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();           ///< its center
  float radius = 0.0f;                                       ///< pixels
};

template <typename Visit, ConstOr<Ball> T>
void fields(Visit&& visit, T& ball) {
  visit(ball.position, ball.covariance, ball.pixel, ball.radius);
}

struct FieldPercept {
  std::vector<LinePoint> line_points;
  std::vector<GoalPost> goal_posts;
  std::vector<Obstacle> obstacles;
  std::optional<CenterCircle> center_circle;
  std::vector<Intersection> intersections;
  std::vector<PenaltyMark> penalty_marks;
  std::optional<Ball> ball;
  /// Row of the field's upper border in evenly spaced columns (column i is at (i + 0.5) * width / size()). The image's
  /// height if no field is in view in that column.
  std::vector<float> boundary;

  // Numbers for which reserve() takes memory.
  static constexpr std::size_t kMostLinePoints = 600;
  static constexpr std::size_t kMostLandmarks = 16;  ///< goal posts, and intersections
  static constexpr std::size_t kMostObstacles = 64;
  static constexpr std::size_t kMostPenaltyMarks = 8;

  /// Reserves memory for nearly all that one image can show, so that later frames allocate nothing.
  void reserve() {
    line_points.reserve(kMostLinePoints);
    goal_posts.reserve(kMostLandmarks);
    obstacles.reserve(kMostObstacles);
    intersections.reserve(kMostLandmarks);
    penalty_marks.reserve(kMostPenaltyMarks);
    boundary.reserve(128);
  }

  /// Whether the percept contains features that constrain a pose.
  bool has_landmarks() const { return !line_points.empty() || !goal_posts.empty(); }

  void clear() {
    line_points.clear();
    goal_posts.clear();
    obstacles.clear();
    center_circle.reset();
    intersections.clear();
    penalty_marks.clear();
    ball.reset();
    boundary.clear();
  }
};
template <typename Visit, ConstOr<FieldPercept> T>
void fields(Visit&& visit, T& percept) {
  visit(percept.line_points, percept.goal_posts, percept.obstacles, percept.center_circle, percept.intersections,
        percept.penalty_marks, percept.ball, percept.boundary);
}

}  // namespace reorient
