// SPDX-License-Identifier: MIT
// A robot as one value: itself, its clock, who may disturb it, and where it really is.
#pragma once

#include <memory>

#include "robots/operator.h"
#include "robots/robot.h"
#include "robots/robot_body.h"

namespace reorient {

struct RobotInstance {
  enum class Clock {
    simulated,  ///< observe() returns at once: whoever wants real time waits
    real        ///< observe() waits for the robot
  };

  std::unique_ptr<Robot> robot;
  RobotBody body;
  Clock clock = Clock::simulated;
  Operator* the_operator = nullptr;          ///< part of the robot; nullptr: it cannot be lifted or placed
  const GroundTruthSource* truth = nullptr;  ///< part of the robot; nullptr: nobody knows
};

}  // namespace reorient
