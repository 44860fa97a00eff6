// SPDX-License-Identifier: MIT
// The person beside the field, who can do to a robot what it cannot do itself, and who sees where it really is.
// Scenarios play that person; only a simulator, or a hall with tracking cameras, can serve them. All poses are in the
// axes of the hall: those of the robot's team before sides are changed.
#pragma once

#include <optional>

#include "geometry/const_or.h"
#include "geometry/pose2.h"

namespace reorient {

class Operator {
 public:
  virtual ~Operator() = default;
  virtual void pick_up() = 0;                     ///< the robot hangs in the air until it is put down
  virtual void put_down(const Pose2& where) = 0;  ///< upright, standing
  virtual void push_over() = 0;                   ///< the robot falls
  virtual void penalize(bool penalized) = 0;      ///< while it is penalized it neither walks nor gets up
  /// The hall's light against the camera's exposure, in powers of two.
  virtual void set_exposure_compensation(double stops) = 0;
  virtual void change_light() = 0;  ///< another light begins, and with it other things on the walls and other people
};

/// Where a robot really is.
struct GroundTruth {
  Pose2 pose;
  bool fallen = false;
  bool carried = false;
};
template <typename Visit, ConstOr<GroundTruth> T>
void fields(Visit&& visit, T& truth) {
  visit(truth.pose, truth.fallen, truth.carried);
}

class GroundTruthSource {
 public:
  virtual ~GroundTruthSource() = default;
  /// At the last observation; empty if it is unknown.
  virtual std::optional<GroundTruth> truth() const = 0;
};

}  // namespace reorient
