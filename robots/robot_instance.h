// SPDX-License-Identifier: MIT
// A robot as one value, with its clock, its operator and its ground truth.
#pragma once

#include <memory>

#include "robots/operator.h"
#include "robots/robot.h"
#include "robots/robot_body.h"

namespace reorient {

struct RobotInstance {
  enum class Clock {
    simulated,  ///< observe() returns at once; for real time, the caller must wait
    real        ///< observe() waits for the robot
  };

  std::unique_ptr<Robot> robot;
  RobotBody body;
  Clock clock = Clock::simulated;
  Operator* the_operator = nullptr;          ///< owned by the robot; nullptr: it cannot be lifted or placed
  const GroundTruthSource* truth = nullptr;  ///< owned by the robot; nullptr: the true pose is unknown
};

}  // namespace reorient
