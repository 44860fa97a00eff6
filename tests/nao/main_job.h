// SPDX-License-Identifier: MIT
// The main job of a robot that only turns its head: it learns the room, the operator moves it to the mirrored pose of
// its belief, and it detects this and flips.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "engine/frame.h"
#include "robots/nao/nao.h"
#include "robots/simulator/simulator.h"
#include "tests/paths.h"
#include "workbench/files/script_files.h"
#include "workbench/run/run_loop.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient::main_job {

inline RobotBody body_without_legs_to_walk_with() {
  RobotBody body;
  body.gait.reset();
  body.get_up_time.reset();
  return body;
}

inline SimulatorParameters with_images_of_width(int width) {
  SimulatorParameters parameters;
  parameters.width = width;
  return parameters;
}

inline const Room& hall() {
  static const Room room = procedural_hall(1, room_shape_for(FieldDimensions{}));
  return room;
}

inline Pose2 beside_the_field() { return Pose2(-FieldDimensions{}.penalty_mark_x, -3.5, kPi / 2.0); }

/// The commands that were granted during the run.
struct Flips : Observer {
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    if (frame.reorientation && frame.reorientation->reorientation == Reorientation::flip_pose) ++count;
  }
  int count = 0;
};

/// Plays the scenario and returns its verdict.
inline std::optional<ScenarioVerdict> play(RobotInstance& robot, std::uint64_t seed, Flips& flips,
                                           Observer* another = nullptr) {
  const ScriptTexts scripts = read_scripts(std::filesystem::path(kSourceFolder) / "scripts");
  RecordedBehaviors behaviors;
  ScenarioHost scenario(scripts, "scenarios/mirrored_placement.lua", {}, behaviors, seed);
  FrameSetup setup;
  setup.body = robot.body;
  setup.seed = seed;
  setup.scripts = scripts;
  for (const std::string& name : scenario.wanted_behaviors()) setup.behaviors.push_back("behaviors/" + name + ".lua");
  FrameLoop engine(std::move(setup));
  RunParts parts{robot, engine, &scenario, &behaviors, {}, {&flips}, {}, 200.0, false};
  if (another != nullptr) parts.observers.push_back(another);
  RunLoop(std::move(parts)).run();
  return scenario.record().verdict;
}

/// Waits until the robot stands, as after a press of its button, before the scenario starts.
inline bool stand_up(nao::Nao& nao) {
  Observation observation;
  while (nao.guard().state != nao::GuardState::standing) {
    if (!nao.observe(observation)) return false;
    nao.answer({});
  }
  return true;
}

}  // namespace reorient::main_job
