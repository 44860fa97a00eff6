// SPDX-License-Identifier: MIT
// Time of scripts: a frame of all shipped behaviors, one call, a reload, stopping a runaway script.
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "engine/script/sandbox/sandbox.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

const std::filesystem::path kScripts = std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts";

/// A world that changes slightly in each frame.
void step(World& world) {
  world.time += world.time_step;
  ++world.frame;
  const double wave = 0.1 * static_cast<double>(world.frame % 10);
  world.head = {wave, -0.1};
  world.pose.pose = Pose2(wave, -wave, wave);
  world.pose.reflected_weight = 0.01 * wave;
  world.confidence.current = 0.5 + 0.1 * wave;
  world.confidence.opposite = 0.1 * wave;
  world.confidence.raw_current = wave;
  world.confidence.raw_opposite = 1.0 - wave;
  world.confidence.coverage = 0.9;
  world.confidence.distinctiveness = 0.3;
  world.trained_seconds += world.time_step;
  world.line_points = static_cast<int>(world.frame % 40);
}

void BM_FrameOfAllShippedBehaviors(benchmark::State& state) {
  ParameterRegistry parameters;
  Behaviors behaviors(read_scripts(kScripts), parameters);
  for (const std::string& file : behaviors.host().texts().in_folder("behaviors")) behaviors.host().load(file);
  World world = world_of(FieldDimensions(), RobotBody());
  world.pose_known = true;
  for ([[maybe_unused]] auto _ : state) {
    step(world);
    behaviors.tick(world);
    benchmark::DoNotOptimize(behaviors.wanted());
  }
}
BENCHMARK(BM_FrameOfAllShippedBehaviors);

/// One behavior whose `update` is an empty function: the time of a call from C++.
void BM_CallOfAnEmptyFunction(benchmark::State& state) {
  Sandbox sandbox{ScriptLimits{}};
  sandbox.grant(1'000'000'000'000);
  sandbox.compile("return function() end", "empty");
  sandbox.call(0, 1);
  const int function = luaL_ref(sandbox.state(), LUA_REGISTRYINDEX);
  for ([[maybe_unused]] auto _ : state) {
    lua_rawgeti(sandbox.state(), LUA_REGISTRYINDEX, function);
    benchmark::DoNotOptimize(sandbox.call(0, 0));
  }
}
BENCHMARK(BM_CallOfAnEmptyFunction);

/// Hash, compile, declare, validate, swap and run one frame.
void BM_Reload(benchmark::State& state) {
  ParameterRegistry parameters;
  Behaviors behaviors(read_scripts(kScripts), parameters);
  behaviors.host().load("orientation");
  const std::string text = behaviors.host().texts().find("behaviors/orientation.lua")->text;
  World world = world_of(FieldDimensions(), RobotBody());
  std::vector<ScriptEdit> edits(1);
  int count = 0;
  for ([[maybe_unused]] auto _ : state) {
    edits[0] = {"behaviors/orientation.lua", ScriptText{text + "-- " + std::to_string(++count), ""}};
    if (!behaviors.host().apply(edits).at(0).accepted) state.SkipWithError("the edit was rejected");
    step(world);
    behaviors.tick(world);
    benchmark::DoNotOptimize(behaviors.wanted());
  }
}
BENCHMARK(BM_Reload)->Unit(benchmark::kMicrosecond);

/// Time from the call to the error, for scripts that never end by themselves.
void end_runaway(benchmark::State& state, const std::string& body) {
  const ScriptLimits limits;
  Sandbox sandbox(limits);
  sandbox.grant(limits.instructions_per_load);
  sandbox.compile("return function() " + body + " end", "runaway");
  sandbox.call(0, 1);
  const int function = luaL_ref(sandbox.state(), LUA_REGISTRYINDEX);
  for ([[maybe_unused]] auto _ : state) {
    sandbox.grant(limits.instructions_per_frame);
    lua_rawgeti(sandbox.state(), LUA_REGISTRYINDEX, function);
    if (!sandbox.call(0, 0)) state.SkipWithError("the script ended by itself");
  }
}
BENCHMARK_CAPTURE(end_runaway, loop, "while true do end")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, loop_in_pcall, "while true do pcall(function() while true do end end) end")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, pattern, "(\"a\"):rep(700):find(\".-.-.-b\")")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, recursion, "local function f() return 1 + f() end f()")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, table, "local t = {} for i = 1, 1e12 do t[i] = i end")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, tables, "local t = {} while true do t = { t, {}, {}, {} } end")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, text_as_limit,
                  "local t = (' '):rep(4000) .. '1' while true do for i = 1, t do break end end")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, compared_texts,
                  "local a, b = ('x'):rep(4000) .. '1', ('x'):rep(4000) .. '2' local c while true do c = a < b end")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, caught_errors, "while true do pcall(error) end")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(end_runaway, format, "while true do string.format(\"%99.99f\", 1e308) end")
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace reorient
