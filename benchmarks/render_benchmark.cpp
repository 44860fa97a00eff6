// SPDX-License-Identifier: MIT
// Time of one simulated frame: moving the world, rendering it, reading the sensor.
#include <cmath>

#include <benchmark/benchmark.h>

#include "robots/simulator/simulator.h"

namespace reorient {
namespace {

void simulate(benchmark::State& state, bool labels) {
  static const Room hall = procedural_hall(1, RoomShape{});
  SimulatorParameters parameters;
  parameters.width = static_cast<int>(state.range(0));
  parameters.labels = labels;
  Simulator simulator(parameters, RobotBody(), FieldDimensions{}, hall, Pose2(-3.2, -3.5, 0.5 * kPi), 1);
  Observation observation;
  int frame = 0;
  for ([[maybe_unused]] auto _ : state) {
    Answer answer;  // scans the field from side to side
    answer.request.head = HeadRequest{{1.2 * std::sin(0.03 * frame++), 0.1}, 3.0};
    simulator.answer(answer);
    simulator.observe(observation);
    benchmark::DoNotOptimize(observation.upper->image.data);
  }
  state.SetItemsProcessed(state.iterations() * observation.upper->image.width * observation.upper->image.height);
}

void simulated_frame(benchmark::State& state) { simulate(state, false); }
void simulated_frame_with_labels(benchmark::State& state) { simulate(state, true); }

void procedural_hall_made(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(procedural_hall(1, RoomShape{}).walls.texels_per_meter());
}

BENCHMARK(simulated_frame)->ArgName("width")->Arg(640)->Arg(320)->Arg(160)->Unit(benchmark::kMillisecond);
BENCHMARK(simulated_frame_with_labels)->ArgName("width")->Arg(160)->Unit(benchmark::kMillisecond);
BENCHMARK(procedural_hall_made)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace reorient
