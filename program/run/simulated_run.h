// A scenario on the simulator, frame by frame.
#pragma once

#include <memory>
#include <optional>

#include "engine/frame.h"
#include "engine/script/script_host.h"
#include "program/run/run_options.h"
#include "program/tuning.h"
#include "robots/simulator/simulator.h"
#include "workbench/run/frame_times.h"

namespace reorient {

class SimulatedRun {
 public:
  /// Throws std::runtime_error (of scripts: ScriptError) with one line on bad input.
  explicit SimulatedRun(const SimulationOptions& options);
  SimulatedRun(const SimulatedRun&) = delete;
  SimulatedRun& operator=(const SimulatedRun&) = delete;

  /// One frame, and what the scenario wants done from outside. False: there is none any more, since the scenario gave
  /// its verdict or the time is up.
  bool step();

  const FrameLoop& frame() const { return *frame_; }
  ScriptHost& scripts() { return *scripts_; }
  ParameterRegistry& parameters() { return tuning_.registry; }
  /// s in wall-clock time that the robot took to observe in the last frame: to render.
  double observing() const { return timed_robot_->observing(); }
  /// The scenario's, once it gave one.
  const std::optional<ScenarioVerdict>& verdict() const { return frame_->script_output().verdict; }

 private:
  double longest_;  ///< s
  Tuning tuning_;
  std::unique_ptr<ScriptHost> scripts_;
  std::unique_ptr<Room> room_;
  std::unique_ptr<Simulator> simulator_;
  std::unique_ptr<TimedRobot> timed_robot_;
  std::unique_ptr<FrameLoop> frame_;
};

}  // namespace reorient
