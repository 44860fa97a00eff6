// SPDX-License-Identifier: MIT
// The one loop around the engine: robot, inputs, step, scenario, observers, pace, stop.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "engine/frame.h"
#include "robots/robot_instance.h"
#include "workbench/run/observer.h"
#include "workbench/run/run_end.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// Adds to the inputs of a frame just before it: a watcher of files, or the prompt.
class InputSource {
 public:
  virtual ~InputSource() = default;
  virtual void add_to(FrameInputs& inputs) = 0;
};

/// All parts must outlive the loop.
struct RunParts {
  RobotInstance& robot;
  FrameLoop& engine;
  ScenarioHost* scenario = nullptr;        ///< needs an operator of the robot
  RecordedBehaviors* behaviors = nullptr;  ///< the view of them for the scenario
  std::vector<InputSource*> sources;
  std::vector<Observer*> observers;
  std::function<bool()> stop;  ///< called after each frame; may be empty
  double longest = 0.0;        ///< s of the robot's time, from its first frame; 0: no limit
  bool in_real_time = false;   ///< waits for the wall clock if the robot does not
};

class RunLoop {
 public:
  explicit RunLoop(RunParts parts);

  /// Runs one frame. Nothing: the run continues.
  std::optional<RunEnd> step();
  /// Runs until the end, then notifies the observers.
  RunEnd run();

  const SceneTruth& scene() const { return scene_; }

 private:
  std::optional<RunEnd> is_over() const;
  void play_scenario();
  void wait() const;

  RunParts parts_;
  FrameInputs inputs_;
  SceneTruth scene_;
  bool any_frame_ = false;
  double first_time_ = 0.0;  // s, of the robot's first frame
  std::chrono::steady_clock::time_point start_;
};

}  // namespace reorient
