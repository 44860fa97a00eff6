// SPDX-License-Identifier: MIT
// The operator beside the field, who can lift, place and push the robot, and who sees its true pose. Scenarios play the
// operator; only a simulator or a hall with tracking cameras can implement it. All poses are in the axes of the hall:
// the axes of the robot's team before the teams change sides.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "geometry/const_or.h"
#include "geometry/pose2.h"

namespace reorient {

class Operator {
 public:
  virtual ~Operator() = default;
  virtual void pick_up() = 0;                     ///< the robot hangs in the air until it is placed
  virtual void put_down(const Pose2& where) = 0;  ///< upright, standing
  virtual void push_over() = 0;                   ///< the robot falls
  virtual void penalize(bool penalized) = 0;      ///< a penalized robot neither walks nor gets up
  /// Brightness of the hall relative to the exposure of the camera, in powers of two.
  virtual void set_exposure_compensation(double stops) = 0;
  virtual void change_light() = 0;  ///< changes the light, and the objects on the walls and the people with it
  /// Places the ball at rest (m). No effect without a ball.
  virtual void put_ball(const Eigen::Vector2d& /*where*/) {}
};

/// The true state of a robot.
struct GroundTruth {
  Pose2 pose;
  bool fallen = false;
  bool carried = false;
};
template <typename Visit, ConstOr<GroundTruth> T>
void fields(Visit&& visit, T& truth) {
  visit(truth.pose, truth.fallen, truth.carried);
}

/// The true state of the ball and the score.
struct BallTruth {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m
  int goals = 0;                                       ///< of this robot's team: in the goal at positive x
  int opponents_goals = 0;
};

class GroundTruthSource {
 public:
  virtual ~GroundTruthSource() = default;
  /// True state at the last observation; empty if it is unknown.
  virtual std::optional<GroundTruth> truth() const = 0;
  /// The same of the ball; empty without a ball.
  virtual std::optional<BallTruth> true_ball() const { return std::nullopt; }
};

}  // namespace reorient
