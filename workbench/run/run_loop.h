// SPDX-License-Identifier: MIT
// The one loop around the engine: robot, requests of the user, inputs, step, scenario, observers, pace, stop.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/frame.h"
#include "robots/robot_instance.h"
#include "workbench/run/observer.h"
#include "workbench/run/run_controls.h"
#include "workbench/run/run_end.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// Adds to the inputs of a frame just before it: a watcher of files, or the prompt.
class InputSource {
 public:
  virtual ~InputSource() = default;
  virtual void add_to(FrameInputs& inputs) = 0;
  /// While the run is paused, instead of add_to() and more than once for each frame. `last`, `scene`: the last frame.
  virtual void add_while_paused(FrameInputs& /*inputs*/, const FrameRecord& /*last*/, const SceneTruth& /*scene*/) {}
};

/// All parts must outlive the loop.
struct RunParts {
  RobotInstance& robot;
  FrameLoop& engine;
  ScenarioHost* scenario = nullptr;        ///< needs an operator of the robot
  RecordedBehaviors* behaviors = nullptr;  ///< the view of them for the scenario
  std::vector<InputSource*> sources;
  std::vector<Observer*> observers;
  std::function<bool()> stop;         ///< called after each frame; may be empty
  double longest = 0.0;               ///< s of the robot's time, from its first frame; 0: no limit
  bool in_real_time = false;          ///< waits for the wall clock if the robot does not
  RunControls* controls = nullptr;    ///< requests of the user; nullptr: no user
  std::function<bool()> continues{};  ///< whether it continues after the scenario's verdict; may be empty
};

class RunLoop {
 public:
  explicit RunLoop(RunParts parts);

  /// Runs one frame, also if the run is paused. Nothing: the run continues.
  std::optional<RunEnd> step();
  /// Runs until the end, with its pauses, then notifies the observers.
  RunEnd run();

  const SceneTruth& scene() const { return scene_; }

 private:
  std::optional<RunEnd> is_over() const;
  std::optional<RunEnd> rest();
  void carry_out_requests();
  void play_scenario();
  void show_requests();
  void wait();

  RunParts parts_;
  FrameInputs inputs_;
  SceneTruth scene_;
  TeamScore score_;
  bool any_frame_ = false;
  double first_time_ = 0.0;                  // s, of the robot's first frame
  RunPace real_time_;                        // without RunParts::controls
  std::vector<RunControls::Issued> issued_;  // carried out just before this frame
  std::vector<OperatorAction> actions_;      // the actions of these
};

}  // namespace reorient
