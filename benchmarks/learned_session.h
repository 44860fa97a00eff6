// SPDX-License-Identifier: MIT
// A recorded short run on the simulator, replayed forward and backward, so that frames are timed without rendering.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "engine/frame.h"
#include "robots/simulator/simulator.h"
#include "workbench/files/field_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

inline const std::filesystem::path kProject = REORIENT_SOURCE_DIR;
inline const Pose2 kStart(-3.2, -3.5, 0.5 * kPi);  // start pose of the scenario

inline FrameSetup shipped(const FieldDimensions& field) {
  FrameSetup setup;
  setup.field = field;
  setup.scripts = read_scripts(kProject / "scripts");
  RecordedBehaviors none;
  setup.behaviors = ScenarioHost(setup.scripts, "mirrored_placement", {}, none).wanted_behaviors();
  return setup;
}

/// A short recording, replayed forward and backward, so that head and odometry never jump.
class ToAndFro {
 public:
  /// Records every second frame of `seconds` on the simulator.
  ToAndFro(int width, const FieldDimensions& field, double seconds) {
    SimulatorParameters parameters;
    parameters.width = width;
    Simulator simulator(parameters, RobotBody(), field, procedural_hall(1, RoomShape{}), kStart, 1);
    FrameLoop engine(shipped(field));
    FrameInputs inputs;
    inputs.external.initial_pose = InitialPose{kStart};
    for (bool kept = true; engine.record().world.time < seconds; kept = !kept) {
      simulator.observe(inputs.observation);
      simulator.answer(engine.step(inputs).answer);
      inputs.external = {};
      if (kept) keep(inputs.observation);
    }
  }

  void observe(Observation& observation) {
    const std::size_t place = frame_ % (2 * observations_.size() - 2);
    const std::size_t index = place < observations_.size() ? place : 2 * observations_.size() - 2 - place;
    observation = observations_[index];
    observation.upper->image.data = images_[index].data();
    observation.time = observation.upper->time = static_cast<double>(frame_++) / 15.0;
  }

 private:
  void keep(const Observation& observation) {
    observations_.push_back(observation);
    observations_.back().lower.reset();
    observations_.back().body_samples = {};
    const ImageView& image = observation.upper->image;
    images_.emplace_back(image.data, image.data + static_cast<std::ptrdiff_t>(image.height) * image.stride);
  }

  std::vector<Observation> observations_;
  std::vector<std::vector<std::uint8_t>> images_;
  std::size_t frame_ = 0;
};

/// A session with a learned room, in which each frame is trained and evaluated.
struct LearnedSession {
  explicit LearnedSession(int width)
      : field(load_field(kProject / "assets" / "fields" / "spl.toml")),
        seen(width, field, 4.0),
        engine(shipped(field)) {
    constexpr double kLearned = 40.0;  // s, after which background_training evaluates in any case
    inputs.external.initial_pose = InitialPose{kStart};
    while (engine.record().world.time < kLearned) step();
  }

  const FrameRecord& step() {
    seen.observe(inputs.observation);
    const FrameRecord& record = engine.step(inputs);
    inputs.external = {};
    return record;
  }

  FieldDimensions field;
  ToAndFro seen;
  FrameLoop engine;
  FrameInputs inputs;
};

}  // namespace reorient
