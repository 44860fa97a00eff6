// SPDX-License-Identifier: MIT
// Counts the heap allocations of one frame of the whole engine. The test replaces operator new, so it is a separate
// program. Lua allocates the memory of scripts with the sandbox's own allocator, within its limits.
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "engine/frame.h"
#include "robots/simulator/simulator.h"
#include "tests/paths.h"
#include "workbench/files/script_files.h"

namespace {

bool counting = false;
bool is_steady = false;
long allocations = 0;
long stop_at = -1;

void* allocate(std::size_t size) {
  // REORIENT_STOP_AT_ALLOCATION=0 stops a debugger at the first unexpected allocation.
  if (counting && allocations++ == stop_at && is_steady) std::abort();
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
// Not inlined, because the compiler would warn that a pointer of operator new is passed to free().
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace reorient {
namespace {

/// A behavior that runs `callee` in two states, with an argument of each type, and changes between them after `period`
/// (s). Its names are longer than the texts that a std::string holds without the heap.
std::string calling_behavior(const std::string& name, const std::string& callee, const std::string& period) {
  const std::string run = callee.empty() ? "" : "run \"" + callee + R"(" {
    distance_to_the_point = function() return 0.1 * pose.x end,
    count = 2,
    is_in_a_hurry = function() return pose.y > 0 end,
    way = "around the obstacle",
    foot = function() return pose.x > 0 and "left" or "right" end,
  },)";
  return R"(local a = args {
  distance_to_the_point = { 0.0, range = { -10, 10 }, unit = "m", doc = "where" },
  count = { 1, range = { 1, 3 }, integer = true, doc = "how often" },
  is_in_a_hurry = { false, doc = "whether it hurries" },
  way = { "straight ahead", choices = { "straight ahead", "around the obstacle" }, doc = "which way" },
  foot = { "left", choices = { "left", "right" }, doc = "which foot" },
}
local function look() head.look(a.distance_to_the_point, a.is_in_a_hurry and 0.1 or 0.2) end
local function has_waited() return )" +
         (callee.empty() ? std::string("false")
                         : "called." + callee + ".outcome == \"done\" and called." + callee + ".reason ~= nil") +
         R"( end
behavior ")" +
         name + R"(" { initial = "in the state near the point",
  state "in the state near the point" { update = look, )" +
         run + R"(
    { "in the state far from it", after = )" +
         period + R"(, because = "it was near for long enough" },
    { "in the state far from it", when = has_waited, because = "the behavior that it runs has ended" },
  },
  state "in the state far from it" { update = look, )" +
         run + R"(
    { "in the state near the point", when = function() return a.count == 1 end, lasting = )" +
         period + R"(, because = "it was far away for long enough" },
    { "at the end of what it does", after = function() return a.count > 1 and 0.2 or 1000 end,
      because = "it was run for long enough" },
  },
  state "at the end of what it does" { ends = "done" },
})";
}

/// A robot that walks between the penalty marks and has learned the room.
class SteadyState : public testing::TestWithParam<Cameras> {
 protected:
  SteadyState() {
    SimulatorParameters parameters;
    parameters.width = 160;
    parameters.cameras = GetParam();
    FrameSetup setup;
    setup.scripts = read_scripts(std::filesystem::path(kSourceFolder) / "scripts");
    setup.behaviors = {"orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan",
                       "get_up",      "penalty_marks",       "outermost"};
    // Three levels of calls. The inner two are given a count above 1, so that they end.
    setup.scripts.apply({"behaviors/outermost.lua", ScriptText{calling_behavior("outermost", "middle", "2"), ""}});
    setup.scripts.apply({"behaviors/middle.lua", ScriptText{calling_behavior("middle", "innermost", "0.5"), ""}});
    setup.scripts.apply({"behaviors/innermost.lua", ScriptText{calling_behavior("innermost", "", "0.1"), ""}});
    const Pose2 start(-2.0, 1.0, 0.5);
    simulator.emplace(parameters, setup.body, setup.field, procedural_hall(1, {}), start, 1);
    engine.emplace(std::move(setup));
    inputs.external.initial_pose = InitialPose{start};
    if (const char* number = std::getenv("REORIENT_STOP_AT_ALLOCATION")) stop_at = std::atol(number);
  }

  /// Allocations of 20 s after the first minute.
  long allocations_when_steady(Topics wanted) {
    is_steady = false;
    run(60 * 30, wanted);
    is_steady = true;
    allocations = 0;
    run(20 * 30, wanted);
    return allocations;
  }

  void run(int frames, Topics wanted) {
    for (int i = 0; i < frames; ++i) {
      simulator->observe(inputs.observation);
      counting = true;
      const FrameRecord& record = engine->step(inputs, wanted);
      counting = false;
      for (const TransitionRecord& transition : record.transitions)
        transitions_of_the_innermost += is_steady && record.name(transition.machine) == "outermost/middle/innermost";
      simulator->answer(record.answer);
      inputs.external = {};
    }
  }

  std::optional<Simulator> simulator;
  std::optional<FrameLoop> engine;
  FrameInputs inputs;
  int transitions_of_the_innermost = 0;
};

TEST_P(SteadyState, AllocatesNothing) {
  EXPECT_EQ(allocations_when_steady({}), 0);
  EXPECT_GT(engine->record().world.confidence.coverage, 0.5) << "the frames should use all parts of the engine";
  EXPECT_GT(transitions_of_the_innermost, 20) << "behaviors three levels deep should start and end";
}

TEST_P(SteadyState, AllocatesNothingWithAllTopicsRequested) { EXPECT_EQ(allocations_when_steady(Topics::all()), 0); }

INSTANTIATE_TEST_SUITE_P(Cameras, SteadyState, testing::Values(Cameras::upper, Cameras::both),
                         [](const auto& each) { return each.param == Cameras::upper ? "upper" : "both"; });

}  // namespace
}  // namespace reorient
