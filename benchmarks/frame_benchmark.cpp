// What one frame costs on one core, from the camera image to the request, with the shipped scenario and without
// rendering. The bar is 5 ms at 640x480.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "engine/frame.h"
#include "engine/parameters/parameter_registry.h"
#include "robots/simulator/simulator.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

const std::filesystem::path kProject = REORIENT_SOURCE_DIR;
const Pose2 kStart(-3.2, -3.5, 0.5 * kPi);  // where the scenario says that the robot stands

/// The loop with the shipped scenario around some robot.
struct Loop {
  Loop(Robot& robot, const FieldDimensions& field) : scripts(kProject / "scripts", registry) {
    declare(parameters, registry);
    scripts.load_scenario("turned_round");
    frame = std::make_unique<FrameLoop>(robot, scripts, parameters, field, FrameOptions{});
  }

  CoreParameters parameters;
  ParameterRegistry registry;
  ScriptHost scripts;
  std::unique_ptr<FrameLoop> frame;
};

/// A short recording, replayed to and fro so that head and odometry never jump.
class ReplayedRobot : public Robot {
 public:
  /// Records every second frame of `seconds` on the simulator.
  ReplayedRobot(ImageSize size, const FieldDimensions& field, double seconds) {
    SimulatorParameters parameters;
    parameters.image = size;
    Simulator simulator(parameters, field, procedural_hall(1, RoomShape{}), kStart, 1);
    Loop loop(simulator, field);
    for (bool kept = true; loop.frame->world().time < seconds; kept = !kept) {
      loop.frame->step();
      if (kept) keep(loop.frame->observation());
    }
  }

  const RobotDimensions& dimensions() const override { return dimensions_; }
  bool observe(Observation& observation) override {
    const std::size_t place = frame_ % (2 * observations_.size() - 2);
    const std::size_t index = place < observations_.size() ? place : 2 * observations_.size() - 2 - place;
    observation = observations_[index];
    observation.image.data = images_[index].data();
    observation.time = static_cast<double>(frame_++) / 15.0;
    return true;
  }
  void request(const Request&) override {}

 private:
  void keep(const Observation& observation) {
    observations_.push_back(observation);
    const std::uint8_t* first = observation.image.data;
    images_.emplace_back(first,
                         first + static_cast<std::ptrdiff_t>(observation.image.height) * observation.image.stride);
  }

  RobotDimensions dimensions_;
  std::vector<Observation> observations_;
  std::vector<std::vector<std::uint8_t>> images_;
  std::size_t frame_ = 0;
};

/// With the room learned: its view is trained and evaluated in every frame.
struct Session {
  explicit Session(ImageSize size)
      : field(load_field(kProject / "assets" / "fields" / "spl.toml")), robot(size, field, 4.0), loop(robot, field) {
    constexpr double kLearned = 40.0;  // s, beyond which background_training evaluates whatever it has seen
    while (loop.frame->world().time < kLearned) loop.frame->step();
  }

  FieldDimensions field;
  ReplayedRobot robot;
  Loop loop;
};

void frame(benchmark::State& state) {
  static std::array<std::unique_ptr<Session>, 3> sessions;
  auto& session = sessions.at(static_cast<std::size_t>(state.range(0)));
  if (!session) session = std::make_unique<Session>(static_cast<ImageSize>(state.range(0)));
  FrameLoop& loop = *session->loop.frame;
  double evaluated = 0.0, trained = 0.0, line_points = 0.0, tiles = 0.0;
  for (auto _ : state) {
    loop.step();
    evaluated += loop.world().evaluating;
    trained += loop.world().training;
    line_points += loop.world().line_points;
    tiles += loop.world().confidence.visible_tiles;
  }
  using benchmark::Counter;
  state.counters["evaluated"] = Counter(evaluated, Counter::kAvgIterations);
  state.counters["trained"] = Counter(trained, Counter::kAvgIterations);
  state.counters["line_points"] = Counter(line_points, Counter::kAvgIterations);
  state.counters["tiles"] = Counter(tiles, Counter::kAvgIterations);
}

// 0: 640x480, 1: 320x240, 2: 160x120.
BENCHMARK(frame)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reorient
