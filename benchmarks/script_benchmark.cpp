// SPDX-License-Identifier: MIT
// Time of scripts: a frame of all shipped behaviors, of behaviors that run others, one call, a reload, stopping a
// runaway script.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

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

/// A behavior with two states, which looks at a point. `callee`: what it runs in both; empty: nothing.
std::string looking_behavior(const std::string& name, const std::string& callee) {
  const std::string run =
      callee.empty() ? "" : "run \"" + callee + "\" { x = function() return 0.1 * pose.x end, y = 0.2 },";
  return R"(local a = args {
  x = { 0.0, range = { -10, 10 }, unit = "m", doc = "where" },
  y = { 0.0, range = { -10, 10 }, unit = "m", doc = "where" },
}
local function look() head.look(math.atan(a.y - pose.y, a.x - pose.x) - pose.rotation, 0.1) end
behavior ")" +
         name + R"(" { initial = "near",
  state "near" { update = look, )" +
         run + R"( { "far", when = function() return pose.x > 0.85 end } },
  state "far" { update = look, )" +
         run + R"( { "near", when = function() return pose.x < 0.15 end, lasting = 0.1 } } })";
}

/// Twelve behaviors: each by its own name, or four that run four which run four.
ScriptTexts twelve_behaviors(bool call) {
  ScriptTexts texts;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "b" + std::to_string(i);
    const std::string callee = call && i < 8 ? "b" + std::to_string(i + 4) : "";
    texts.apply({"behaviors/" + name + ".lua", ScriptText{looking_behavior(name, callee), ""}});
  }
  return texts;
}

void frame_of_twelve_behaviors(benchmark::State& state, bool call) {
  ParameterRegistry parameters;
  Behaviors behaviors(twelve_behaviors(call), parameters);
  for (int i = 0; i < (call ? 4 : 12); ++i) behaviors.host().load("b" + std::to_string(i));
  if (behaviors.host().definitions().size() != 12) state.SkipWithError("expected 12 machines");
  World world = world_of(FieldDimensions(), RobotBody());
  for ([[maybe_unused]] auto _ : state) {
    step(world);
    behaviors.tick(world);
    benchmark::DoNotOptimize(behaviors.wanted());
  }
}
BENCHMARK_CAPTURE(frame_of_twelve_behaviors, alone, false);
BENCHMARK_CAPTURE(frame_of_twelve_behaviors, in_three_levels, true);

/// The time below which 99 % of the times lie; 0 without times.
double percentile_99(std::vector<double> times) {
  if (times.empty()) return 0.0;
  const auto place = times.begin() + static_cast<std::ptrdiff_t>(times.size() * 99 / 100);
  std::nth_element(times.begin(), place, times.end());
  return *place;
}

/// A behavior that four others run: four scripts are compiled, and continue.
void BM_ReloadOfACalledBehavior(benchmark::State& state) {
  ParameterRegistry parameters;
  ScriptTexts texts;
  texts.apply({"behaviors/called.lua", ScriptText{looking_behavior("called", ""), ""}});
  for (int i = 0; i < 4; ++i) {
    const std::string name = "b" + std::to_string(i);
    texts.apply({"behaviors/" + name + ".lua", ScriptText{looking_behavior(name, "called"), ""}});
  }
  Behaviors behaviors(std::move(texts), parameters);
  for (int i = 0; i < 4; ++i) behaviors.host().load("b" + std::to_string(i));
  World world = world_of(FieldDimensions(), RobotBody());
  std::vector<ScriptEdit> edits(1);
  std::vector<double> times;  // us, of the clock on the wall
  int count = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    edits[0] = {"behaviors/called.lua",
                ScriptText{looking_behavior("called", "") + "-- " + std::to_string(++count), ""}};
    if (behaviors.host().apply(edits).size() != 4) state.SkipWithError("expected four reloads");
    step(world);
    behaviors.tick(world);
    benchmark::DoNotOptimize(behaviors.wanted());
    times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  }
  state.counters["us_for_99_percent"] = percentile_99(std::move(times));
}
BENCHMARK(BM_ReloadOfACalledBehavior)->Unit(benchmark::kMicrosecond);

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
