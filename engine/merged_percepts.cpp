// SPDX-License-Identifier: MIT
#include "engine/merged_percepts.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/intersection_direction.h"
#include "geometry/angle.h"
#include "geometry/square.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSamePlace = 0.5;     // m; two landmarks of one type are never so close together
constexpr double kSameBearing = 0.08;  // rad; the two posts of a goal never appear so close together

/// In (-pi/2, pi/2].
double half_turn(double angle) {
  const double normal = normalize_angle(angle);
  if (normal > 0.5 * kPi) return normal - kPi;
  return normal <= -0.5 * kPi ? normal + kPi : normal;
}

template <typename Feature>
void remove_same(std::vector<Feature>& own, const Vector2d& position) {
  std::erase_if(own, [&](const Feature& one) { return (one.position - position).norm() < kSamePlace; });
}

class PerceptAdder {
 public:
  PerceptAdder(const DetectorCameras& cameras, const FieldDimensions& field, const FieldFeatureParameters& features,
               std::array<FieldPercept, 2>& percepts)
      : views_(cameras, field),
        features_(features),
        ball_radius_(0.5 * field.ball_diameter),
        goal_height_(field.goal_height),
        percepts_(percepts) {
    for (std::size_t i = 0; i < percepts.size(); ++i) own_intersections_[i] = percepts[i].intersections.size();
  }

  /// Intersections need the lines, so they come last.
  void add(std::span<const ExternalPercept> list, double least_confidence) {
    list = list.first(std::min(list.size(), kMostExternalPercepts));
    const ExternalPercept* ball = nullptr;
    const ExternalPercept* circle = nullptr;
    const auto for_each = [&](auto&& use) {
      for (const ExternalPercept& percept : list) {
        if (mistake_in(percept).empty() && percept.confidence >= least_confidence) use(percept);
      }
    };
    const auto keep_surer = [](const ExternalPercept*& best, const ExternalPercept& percept) {
      if (best == nullptr || percept.confidence > best->confidence) best = &percept;
    };
    // First of all remove what both found, so that an external percept never removes another one.
    for_each([&](const ExternalPercept& percept) { remove_own(percept); });
    for_each([&](const ExternalPercept& percept) {
      if (percept.type == PerceptType::ball) keep_surer(ball, percept);
      if (percept.type == PerceptType::center_circle) keep_surer(circle, percept);
      add_one(percept);
    });
    if (ball != nullptr) add_ball(*ball);
    if (circle != nullptr) add_circle(*circle);
    for_each([&](const ExternalPercept& percept) { add_intersection(percept); });
  }

 private:
  static Vector2d sent_point(const ExternalPercept& percept) { return {percept.at[0], percept.at[1]}; }
  std::optional<DetectedPoint> point(const ExternalPercept& percept) const {
    return views_.point(percept.space, sent_point(percept));
  }
  Matrix2d covariance(const ExternalPercept& percept, const DetectedPoint& seen) const {
    return views_.covariance(percept, seen, features_);
  }

  std::optional<DetectedPoint> post_point(const ExternalPercept& percept) const {
    if (percept.space == PerceptSpace::ground || !percept.base_hidden) return point(percept);
    return views_.point(percept.space, {percept.at[2], percept.at[3]}, goal_height_);
  }

  void remove_own(const ExternalPercept& percept) {
    switch (percept.type) {
      case PerceptType::line:
        return remove_line(percept);
      case PerceptType::goal_post:
        if (const auto seen = post_point(percept)) {
          const double bearing = direction_of(seen->position);
          for (FieldPercept& own : percepts_)
            std::erase_if(own.goal_posts, [&](const GoalPost& post) {
              return std::abs(angle_difference(direction_of(post.position), bearing)) < kSameBearing;
            });
        }
        return;
      case PerceptType::penalty_mark:
        if (const auto seen = point(percept)) {
          for (FieldPercept& own : percepts_) remove_same(own.penalty_marks, seen->position);
        }
        return;
      case PerceptType::robot:
      case PerceptType::person:
        for (std::size_t i = 0; i < percepts_.size(); ++i) {
          const std::optional<Obstacle> box = views_.box_in(percept, i);
          if (!box) continue;
          std::erase_if(percepts_[i].obstacles, [&](const Obstacle& own) {
            const int middle = (own.left + own.right) / 2;
            return middle >= box->left && middle <= box->right;
          });
        }
        return;
      case PerceptType::line_point:
      case PerceptType::ball:
      case PerceptType::center_circle:
      case PerceptType::l_intersection:  // they are removed when these are added
      case PerceptType::t_intersection:
      case PerceptType::x_intersection:
        return;
    }
  }

  void remove_line(const ExternalPercept& percept) {
    constexpr double kBeside = 0.1;  // m
    const auto from = point(percept), to = views_.point(percept.space, {percept.at[2], percept.at[3]});
    if (!from || !to) return;
    const Vector2d line = to->position - from->position;
    const double length = line.norm();
    if (!(length > 1e-6)) return;
    for (FieldPercept& own : percepts_)
      std::erase_if(own.line_points, [&](const LinePoint& one) {
        const Vector2d offset = one.position - from->position;
        const double along = offset.dot(line) / length;
        return along >= 0.0 && along <= length && std::abs(cross(line, offset)) / length < kBeside;
      });
  }

  void add_one(const ExternalPercept& percept) {
    switch (percept.type) {
      case PerceptType::line:
        return add_line(percept);
      case PerceptType::line_point:
        if (const auto seen = point(percept)) {
          if (const auto along = views_.direction(percept, *seen)) add_line_point(*seen, *along);
        }
        return;
      case PerceptType::goal_post:
        return add_post(percept);
      case PerceptType::penalty_mark:
        if (const auto seen = point(percept)) {
          std::vector<PenaltyMark>& marks = percepts_[seen->camera].penalty_marks;
          if (marks.size() < FieldPercept::kMostPenaltyMarks)
            marks.push_back({seen->position, covariance(percept, *seen), seen->pixel.cast<float>()});
        }
        return;
      case PerceptType::robot:
      case PerceptType::person:
        for (std::size_t i = 0; i < percepts_.size(); ++i) {
          const std::optional<Obstacle> box = views_.box_in(percept, i);
          if (box && percepts_[i].obstacles.size() < FieldPercept::kMostObstacles)
            percepts_[i].obstacles.push_back(*box);
        }
        return;
      default:  // later
        return;
    }
  }

  void add_line_point(const DetectedPoint& seen, double along) {
    std::vector<LinePoint>& points = percepts_[seen.camera].line_points;
    if (points.size() < FieldPercept::kMostLinePoints)
      points.push_back({seen.position, half_turn(along + 0.5 * kPi), seen.pixel.cast<float>()});
  }

  /// The same number of points as the field vision finds on a line.
  void add_line(const ExternalPercept& percept) {
    constexpr double kStep = 0.1;  // m
    constexpr int kFewest = 2, kMost = 40;
    const Vector2d from = sent_point(percept), to(percept.at[2], percept.at[3]);
    const auto first = views_.point(percept.space, from), last = views_.point(percept.space, to);
    if (!first || !last) return;
    const Vector2d line = last->position - first->position;
    if (!(line.norm() > 0.5 * kStep)) return;
    const double along = direction_of(line);
    const int points = std::clamp(static_cast<int>(std::lround(line.norm() / kStep)), kFewest, kMost);
    for (int i = 0; i < points; ++i) {
      const double fraction = (i + 0.5) / points;
      if (const auto seen = views_.point(percept.space, from + fraction * (to - from))) add_line_point(*seen, along);
    }
  }

  void add_post(const ExternalPercept& percept) {
    const auto seen = post_point(percept);
    if (!seen || percepts_[seen->camera].goal_posts.size() >= FieldPercept::kMostLandmarks) return;
    GoalPost post{.position = seen->position, .base_visible = !percept.base_hidden};
    post.base = post.top = seen->pixel.cast<float>();
    if (percept.space != PerceptSpace::ground) {
      post.base = sent_point(percept).cast<float>();
      post.top = Vector2d(percept.at[2], percept.at[3]).cast<float>();
    } else if (seen->view != nullptr) {
      const auto top = seen->view->pixel(Vector3d(seen->position.x(), seen->position.y(), goal_height_));
      if (top && top->y() < seen->pixel.y()) post.top = top->cast<float>();
    }
    percepts_[seen->camera].goal_posts.push_back(post);
  }

  void add_ball(const ExternalPercept& percept) {
    const auto seen = views_.point(percept.space, sent_point(percept), ball_radius_);
    if (!seen) return;
    for (FieldPercept& own : percepts_) own.ball.reset();
    const bool has_radius = percept.space != PerceptSpace::ground;
    percepts_[seen->camera].ball = Ball{seen->position, covariance(percept, *seen), seen->pixel.cast<float>(),
                                        has_radius ? static_cast<float>(percept.at[2]) : 0.0f};
  }

  void add_circle(const ExternalPercept& percept) {
    const auto seen = point(percept);
    if (!seen) return;
    for (FieldPercept& own : percepts_) own.center_circle.reset();
    CenterCircle circle;
    circle.center = seen->position;
    circle.covariance = covariance(percept, *seen);
    if (const auto along = views_.direction(percept, *seen)) {
      constexpr double kDeviation = 0.05;  // rad
      circle.halfway_direction = half_turn(*along);
      circle.direction_variance = square(kDeviation);
    }
    percepts_[seen->camera].center_circle = circle;
  }

  void add_intersection(const ExternalPercept& percept) {
    const bool is_l = percept.type == PerceptType::l_intersection, is_t = percept.type == PerceptType::t_intersection;
    if (!is_l && !is_t && percept.type != PerceptType::x_intersection) return;
    const auto seen = point(percept);
    if (!seen) return;
    Intersection intersection{.position = seen->position, .covariance = covariance(percept, *seen)};
    intersection.kind = is_l ? IntersectionKind::l : is_t ? IntersectionKind::t : IntersectionKind::x;
    intersection.pixel = seen->pixel.cast<float>();
    // In an image, the direction between the arms of an L is not the one on the ground.
    std::optional<double> along =
        is_l && percept.space != PerceptSpace::ground ? std::nullopt : views_.direction(percept, *seen);
    if (!along) along = own_direction(intersection);
    if (!along) along = direction_from_lines(intersection.kind, intersection.position, percepts_);
    if (!along) return;
    intersection.direction = normalize_angle(*along);
    remove_own_intersections(intersection.position);
    std::vector<Intersection>& list = percepts_[seen->camera].intersections;
    if (list.size() < FieldPercept::kMostLandmarks) list.push_back(intersection);
  }

  /// Of the same intersection, if the field vision found it.
  std::optional<double> own_direction(const Intersection& wanted) const {
    for (std::size_t i = 0; i < percepts_.size(); ++i) {
      for (std::size_t at = 0; at < own_intersections_[i]; ++at) {
        const Intersection& own = percepts_[i].intersections[at];
        if (own.kind == wanted.kind && (own.position - wanted.position).norm() < kSamePlace) return own.direction;
      }
    }
    return std::nullopt;
  }

  void remove_own_intersections(const Vector2d& position) {
    for (std::size_t i = 0; i < percepts_.size(); ++i) {
      std::vector<Intersection>& list = percepts_[i].intersections;
      const auto end = list.begin() + static_cast<std::ptrdiff_t>(own_intersections_[i]);
      const auto kept = std::remove_if(
          list.begin(), end, [&](const Intersection& own) { return (own.position - position).norm() < kSamePlace; });
      own_intersections_[i] = static_cast<std::size_t>(kept - list.begin());
      list.erase(kept, end);
    }
  }

  const DetectorViews views_;
  const FieldFeatureParameters& features_;
  double ball_radius_, goal_height_;  // m
  std::array<FieldPercept, 2>& percepts_;
  std::array<std::size_t, 2> own_intersections_{};  // number of the field vision's, which come first
};

}  // namespace

void add_external(const ExternalPercepts& external, const DetectorCameras& cameras, const FieldDimensions& field,
                  const ExternalPerceptParameters& parameters, const FieldFeatureParameters& features,
                  std::array<FieldPercept, 2>& percepts) {
  if (!cameras[0] && !cameras[1]) return;
  PerceptAdder(cameras, field, features, percepts).add(external.list, parameters.least_confidence);
}

}  // namespace reorient
