// What was seen of the field in one image. Positions are on the ground in the robot frame: m, x forward, y left.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace reorient {

/// A point on the centre of a field line.
struct LinePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
  double normal = 0.0;  ///< direction across the line, rad, known up to half a turn: in (-pi/2, pi/2]
  Eigen::Vector2f pixel = Eigen::Vector2f::Zero();
};

template <typename Visit>
void fields(Visit&& visit, LinePoint& point) {
  visit(point.position, point.normal, point.pixel);
}

struct GoalPost {
  /// m, where the post stands; from the base, or from the height where the base is not in view
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  bool base_visible = true;                        ///< false: the bearing holds, the distance is rough
  Eigen::Vector2f base = Eigen::Vector2f::Zero();  ///< pixel
  Eigen::Vector2f top = Eigen::Vector2f::Zero();   ///< pixel, the highest one found
};

template <typename Visit>
void fields(Visit&& visit, GoalPost& post) {
  visit(post.position, post.base_visible, post.base, post.top);
}

/// Something that stands on the field and hides what is behind it: a robot, a person, a post's neighbour.
struct Obstacle {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m, nearest point on the ground
  int left = 0;                                        ///< image columns that it covers, first and last
  int right = 0;
  int top = 0;  ///< image rows
  int bottom = 0;
};

template <typename Visit>
void fields(Visit&& visit, Obstacle& obstacle) {
  visit(obstacle.position, obstacle.left, obstacle.right, obstacle.top, obstacle.bottom);
}

struct FieldPercept {
  std::vector<LinePoint> line_points;
  std::vector<GoalPost> goal_posts;
  std::vector<Obstacle> obstacles;
  /// Row of the field's upper border in evenly spaced columns (column i is at (i + 0.5) * width / size());
  /// the image's height where no field is in view in that column.
  std::vector<float> boundary;

  /// Memory for what one image shows at most, or nearly so: then no frame has to ask for more.
  void reserve() {
    line_points.reserve(600);
    goal_posts.reserve(16);
    obstacles.reserve(64);
    boundary.reserve(128);
  }

  /// Whether it shows anything by which a pose can be judged.
  bool has_landmarks() const { return !line_points.empty() || !goal_posts.empty(); }

  void clear() {
    line_points.clear();
    goal_posts.clear();
    obstacles.clear();
    boundary.clear();
  }
};
template <typename Visit>
void fields(Visit&& visit, FieldPercept& percept) {
  visit(percept.line_points, percept.goal_posts, percept.obstacles, percept.boundary);
}

}  // namespace reorient
