// SPDX-License-Identifier: MIT
// A robot that stands, with an operator who remembers what he did, and a run of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/frame_fixture.h"
#include "workbench/run/run_loop.h"

namespace reorient {

/// Each frame has the same image.
class HandFedRobot : public Robot, public Operator, public GroundTruthSource {
 public:
  explicit HandFedRobot(const FrameInputs& first) : observation_(first.observation) {}

  bool observe(Observation& observation) override {
    observation = observation_;
    observation_.time += HandFedLoop::kStep;
    observation_.upper->time = observation_.body.time = observation_.time;
    return true;
  }
  void answer(const Answer& /*answer*/) override {}

  void pick_up() override { done.emplace_back("pick_up"); }
  void put_down(const Pose2& where) override {
    done.emplace_back("put_down");
    pose = where;
  }
  void push_over() override { done.emplace_back("push_over"); }
  void penalize(bool penalized) override { done.emplace_back(penalized ? "penalize" : "end the penalty"); }
  void set_exposure_compensation(double stops) override { done.push_back("light " + std::to_string(stops)); }
  void change_light() override { done.emplace_back("change_light"); }
  std::optional<GroundTruth> truth() const override { return GroundTruth{pose, false, false}; }

  Pose2 pose{-3.0, 1.0, 0.5};
  std::vector<std::string> done;

 private:
  Observation observation_;
};

/// A run of this robot, at full speed.
class HandFedRun {
 public:
  explicit HandFedRun(bool has_operator = true, bool sets_pace = true) : controls(has_operator, sets_pace) {
    auto owned = std::make_unique<HandFedRobot>(loop.inputs);
    robot = owned.get();
    instance_.the_operator = has_operator ? robot : nullptr;
    instance_.truth = has_operator ? robot : nullptr;
    instance_.robot = std::move(owned);
  }

  RunParts parts(std::vector<InputSource*> sources, std::vector<Observer*> observers) {
    RunParts parts{instance_, *loop.engine, nullptr, nullptr, std::move(sources), std::move(observers), {}, 0.0, false};
    parts.controls = &controls;
    return parts;
  }

  HandFedLoop loop{kIdle};
  RunControls controls;
  HandFedRobot* robot = nullptr;

 private:
  RobotInstance instance_;
};

}  // namespace reorient
