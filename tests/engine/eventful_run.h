// SPDX-License-Identifier: MIT
// The inputs of a run on the simulator with the shipped behaviors and many events: lifts, falls, penalties, half-times,
// set poses, messages, changed parameters and edited scripts. Stored as bytes, so that many loops can use the same
// inputs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <vector>

#include "engine/frame.h"
#include "engine/record/input_bytes.h"
#include "robots/simulator/simulator.h"
#include "tests/paths.h"
#include "workbench/files/script_files.h"

namespace reorient {

using Bytes = std::vector<std::byte>;

inline const std::filesystem::path kShippedScripts = std::filesystem::path(kSourceFolder) / "scripts";

/// A behavior that stores kept values, uses random numbers and fails from time to time.
inline constexpr const char* kRestless = R"(local memory = keep { count = 0, seen = {} }
behavior "restless" { initial = "turning",
  update = function()
    memory.count = memory.count + 1
    memory.seen[1 + memory.count % 7] = math.random(100)
    if memory.count % 40 == 0 then error("now and then") end
    if memory.count % 15 == 0 then log.info(memory.count .. " " .. math.random(6) .. " " .. #memory.seen) end
  end,
  state "resting" { { "turning", after = 0.1 } },
  state "turning" { initial = "one", history = true, { "resting", after = 1.7 },
  state "one" { enter = function() command.pause_evaluation() end, { "two", after = 0.4 } },
  state "two" { enter = command.flip_pose, { "one", when = function() return math.random() < 0.05 end, lasting = 0.0, because = "by chance" } } },
})";

inline FrameSetup eventful_setup() {
  FrameSetup setup;
  setup.seed = 5;
  setup.scripts = read_scripts(kShippedScripts);
  setup.scripts.apply({"behaviors/restless.lua", ScriptText{kRestless, ""}});
  setup.behaviors = {"orientation", "background_training", "head_scan", "get_up", "kidnap_recovery", "restless"};
  // Start the evaluation early, so that many events happen within a few seconds.
  setup.parameters = {{"background_training.evaluate_at", "0.1", ParameterOrigin::file, "here:1"}};
  return setup;
}

/// The particles of an external particle filter.
inline std::vector<ExternalBelief::Particle> scattered_around(const Pose2& pose) {
  std::vector<ExternalBelief::Particle> particles;
  particles.reserve(32);
  for (int i = 0; i < 30; ++i)
    particles.push_back({pose * Pose2(0.02 * (i % 5), -0.03 * (i % 3), 0.01 * (i % 7)), 1.0 + i % 4});
  particles.push_back({reflect(pose), 5.0});
  particles.push_back({pose, std::numeric_limits<double>::infinity()});
  return particles;
}

/// One element for each frame.
inline std::vector<Bytes> eventful_run(int frames, FrameSetup setup = eventful_setup()) {
  SimulatorParameters parameters;
  parameters.width = 160;
  const Pose2 start(-2.0, 1.0, 0.5);
  Simulator simulator(parameters, RobotBody(), setup.field, procedural_hall(1, {}), start, 5);
  const ScriptText orientation = *setup.scripts.find("behaviors/orientation.lua");
  FrameLoop engine(std::move(setup));
  std::vector<Bytes> run;
  for (int i = 0; i < frames; ++i) {
    FrameInputs inputs;
    const int event = i % 240;
    if (i == 0) inputs.external.initial_pose = InitialPose{start};
    if (event == 60) simulator.pick_up();
    if (event == 80) simulator.put_down(reflect(simulator.ground_truth().pose));
    if (event == 100) inputs.parameter_changes.push_back({"pose_filter.particles", "150", ParameterOrigin::live, ""});
    if (event == 105) inputs.parameter_changes.push_back({"orientation.nothing", "1", ParameterOrigin::live, ""});
    if (event == 110)
      inputs.script_edits.push_back({"behaviors/orientation.lua", ScriptText{orientation.text + "\n-- edited", ""}});
    if (event == 115) inputs.script_edits.push_back({"behaviors/head_scan.lua", ScriptText{"broken(", ""}});
    if (event == 125) simulator.push_over();
    if (event == 150) inputs.external.messages.push_back({3, "I see the ball"});
    if (event == 155) simulator.penalize(true);
    if (event == 170) simulator.penalize(false);
    if (event == 160 || event == 195) inputs.external.half_time = true;
    if (event == 200) inputs.external.initial_pose = InitialPose{simulator.ground_truth().pose};
    simulator.observe(inputs.observation);
    const std::vector<ExternalBelief::Particle> particles = scattered_around(simulator.ground_truth().pose);
    if ((event >= 20 && event < 40) || (event >= 175 && event < 197)) {  // an external localization starts and ends
      ExternalBelief& belief = inputs.observation.belief.emplace();
      if (event < 40) belief.particles = particles;
      belief.pose = simulator.ground_truth().pose;
      if (event == 190) belief.pose.rotation = std::numeric_limits<double>::quiet_NaN();
    }
    write_inputs(inputs, run.emplace_back());
    simulator.answer(engine.step(inputs).answer);
  }
  return run;
}

}  // namespace reorient
