// SPDX-License-Identifier: MIT
// Time of the field features of one simulated image with lines, a goal, other robots and people.
#include <benchmark/benchmark.h>

#include "perception/field/field_features.h"
#include "robots/simulator/simulator.h"

namespace reorient {
namespace {

void field_features(benchmark::State& state) {
  const FieldDimensions field;
  SimulatorParameters parameters;
  parameters.width = static_cast<int>(state.range(0));
  const Room room = procedural_hall(1, {});
  Simulator simulator(parameters, RobotBody(), field, room, {1.0, 0.5, 0.0}, 1);
  Answer answer;
  answer.request.head = HeadRequest{{0.0, 0.15}, 10.0};
  simulator.answer(answer);
  Observation observation;
  for (int i = 0; i < 10; ++i) simulator.observe(observation);
  const CameraFrame& camera = observation.upper.value();
  FieldFeatures features({}, field);
  FieldPercept percept;
  for ([[maybe_unused]] auto _ : state) features.find(camera.image, camera.camera, camera.robot_from_camera, percept);
  state.counters["line_points"] = static_cast<double>(percept.line_points.size());
  state.SetLabel(std::to_string(camera.image.width) + "x" + std::to_string(camera.image.height));
}
BENCHMARK(field_features)->Arg(640)->Arg(320)->Arg(160)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace reorient
