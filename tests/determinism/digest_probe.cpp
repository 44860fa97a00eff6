// SPDX-License-Identifier: MIT
// Three short runs on the simulator. Prints for each the digest of its records, of their numbers without names and
// texts, and of the learned model of the room. The output must be the same on each processor. The program is small, so
// that it can be built for another processor and run in an emulator within a short time. same_as_native compares the
// whole program, with models and recordings as files.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/frame.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/record/digest.h"
#include "perception/room/saved_model.h"
#include "robots/simulator/simulator.h"
#include "tests/determinism/number_digest.h"
#include "tests/paths.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/parameter_file.h"
#include "workbench/files/script_files.h"
#include "workbench/run/digest_observer.h"
#include "workbench/run/run_loop.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

/// One run, the same as `reorient run SCENARIO --width 160`.
struct ProbedRun {
  const char* scenario;
  double seconds;
  Cameras cameras = Cameras::upper;
  std::vector<ParameterChange> parameters{};
};

/// The model of the room in the last frame.
struct ModelDigest : Observer {
  Topics wanted() const override { return {Topic::room}; }
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    learned = frame.world.trained_seconds;
    basis = frame.room.basis;
    tiles.assign(frame.room.model.begin(), frame.room.model.end());
  }
  std::string hex() const {
    std::vector<std::byte> bytes;
    write_model({basis, learned, BackgroundModel(tiles)}, bytes);
    Digest digest;
    digest.add(bytes);
    return digest.hex();
  }

  double learned = 0.0;
  ModelBasis basis;
  decltype(RoomRecord::model) tiles;
};

RobotInstance make_robot(const ProbedRun& run, const RobotBody& body, const FieldDimensions& field) {
  SimulatorParameters tuning = simulator_parameters_of(body);
  tuning.width = 160;
  tuning.cameras = run.cameras;
  RoomShape shape = room_shape_for(field);
  ParameterRegistry registry;
  for (const ParameterChange& change : run.parameters) registry.set_early(change);
  registry.bind("simulator", tuning);
  registry.bind("body", tuning.body);
  registry.bind("sensor", tuning.sensor);
  registry.bind("light", tuning.light);
  registry.bind("room_shape", shape);
  const Pose2 beside_the_field(-field.penalty_mark_x, -0.5 * field.width - 0.5, kPi / 2.0);
  auto simulator = std::make_unique<Simulator>(tuning, body, field, procedural_hall(1, shape), beside_the_field, 1);
  Simulator* const itself = simulator.get();
  return {std::move(simulator), itself->body(), RobotInstance::Clock::simulated, itself, itself};
}

void probe(const ProbedRun& run) {
  const std::filesystem::path source = kSourceFolder;
  const ScriptTexts scripts = read_scripts(source / "scripts");
  const FieldDimensions field = load_field(source / "assets/fields/spl.toml");
  RobotInstance robot = make_robot(run, load_body(source / "assets/robots/nao-v6.toml"), field);
  RecordedBehaviors behaviors;
  ScenarioHost scenario(scripts, std::string("scenarios/") + run.scenario + ".lua", run.parameters, behaviors, 1);
  FrameSetup setup;
  setup.field = field;
  setup.body = robot.body;
  setup.scripts = scripts;
  setup.parameters = run.parameters;
  for (const std::string& name : scenario.wanted_behaviors()) setup.behaviors.push_back("behaviors/" + name + ".lua");
  FrameLoop engine(std::move(setup));
  DigestObserver digest;
  NumberDigest numbers;
  ModelDigest model;
  RunLoop({robot, engine, &scenario, &behaviors, {}, {&digest, &numbers, &model}, {}, run.seconds, false}).run();
  std::printf("%s: records %s, numbers %s, model %s\n", run.scenario, digest.hex().c_str(), numbers.hex().c_str(),
              model.hex().c_str());
}

}  // namespace
}  // namespace reorient

int main() {
  using namespace reorient;
  try {
    probe({"mirrored_placement", 8.0});
    probe({"fallen", 3.0, Cameras::both});
    // Use every loop over pixels of the simulator.
    std::vector<ParameterChange> hard =
        read_parameters(std::string(kSourceFolder) + "/assets/parameters/light/hard.toml");
    hard.push_back({"trial.learn", "2", ParameterOrigin::file, "digest_probe"});
    probe({"trial", 3.0, Cameras::upper, hard});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "digest_probe: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
