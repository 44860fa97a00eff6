// SPDX-License-Identifier: MIT
// Time of one frame on one core from the camera image to the answer, with the behaviors of the default scenario and
// without rendering. The limit is 5 ms at 640x480.
#include <cstddef>
#include <map>

#include <benchmark/benchmark.h>

#include "benchmarks/learned_session.h"

namespace reorient {
namespace {

void frame(benchmark::State& state) {
  static std::map<int, LearnedSession> sessions;
  const int width = static_cast<int>(state.range(0));
  LearnedSession& session = sessions.try_emplace(width, width).first->second;
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
