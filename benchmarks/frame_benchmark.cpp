// What one frame costs on one core, from the camera image to the answer, with the shipped scenario's behaviours and
// without rendering. The bar is 5 ms at 640x480.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

#include <benchmark/benchmark.h>

#include "engine/frame.h"
#include "robots/simulator/simulator.h"
#include "workbench/files/field_file.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

const std::filesystem::path kProject = REORIENT_SOURCE_DIR;
const Pose2 kStart(-3.2, -3.5, 0.5 * kPi);  // where the scenario says that the robot stands

FrameSetup shipped(const FieldDimensions& field) {
  FrameSetup setup;
  setup.field = field;
  setup.scripts = read_scripts(kProject / "scripts");
  RecordedBehaviors none;
  setup.behaviors = ScenarioHost(setup.scripts, "turned_round", {}, none).wanted_behaviors();
  return setup;
}

/// A short recording, replayed to and fro so that head and odometry never jump.
class Replay {
 public:
  /// Records every second frame of `seconds` on the simulator.
  Replay(int width, const FieldDimensions& field, double seconds) {
    SimulatorParameters parameters;
    parameters.width = width;
    Simulator simulator(parameters, RobotBody(), field, procedural_hall(1, RoomShape{}), kStart, 1);
    FrameLoop engine(shipped(field));
    FrameInputs inputs;
    inputs.told.initial_pose = InitialPose{kStart};
    for (bool kept = true; engine.record().world.time < seconds; kept = !kept) {
      simulator.observe(inputs.observation);
      simulator.answer(engine.step(inputs).answer);
      inputs.told = {};
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

/// With the room learned: its view is trained and evaluated in every frame.
struct Session {
  explicit Session(int width)
      : field(load_field(kProject / "assets" / "fields" / "spl.toml")),
        replay(width, field, 4.0),
        engine(shipped(field)) {
    constexpr double kLearned = 40.0;  // s, beyond which background_training evaluates whatever it has seen
    inputs.told.initial_pose = InitialPose{kStart};
    while (engine.record().world.time < kLearned) step();
  }

  const FrameRecord& step() {
    replay.observe(inputs.observation);
    const FrameRecord& record = engine.step(inputs);
    inputs.told = {};
    return record;
  }

  FieldDimensions field;
  Replay replay;
  FrameLoop engine;
  FrameInputs inputs;
};

void frame(benchmark::State& state) {
  static std::map<int, Session> sessions;
  const int width = static_cast<int>(state.range(0));
  Session& session = sessions.try_emplace(width, width).first->second;
  double evaluated = 0.0, trained = 0.0, line_points = 0.0, tiles = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    const World& world = session.step().world;
    evaluated += world.evaluating;
    trained += world.training;
    line_points += world.line_points;
    tiles += world.confidence.visible_tiles;
  }
  using benchmark::Counter;
  state.counters["evaluated"] = Counter(evaluated, Counter::kAvgIterations);
  state.counters["trained"] = Counter(trained, Counter::kAvgIterations);
  state.counters["line_points"] = Counter(line_points, Counter::kAvgIterations);
  state.counters["tiles"] = Counter(tiles, Counter::kAvgIterations);
}

BENCHMARK(frame)->ArgName("width")->Arg(640)->Arg(320)->Arg(160)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reorient
