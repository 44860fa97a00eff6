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

/// A robot that walks between the penalty marks and has learned the room.
class SteadyState : public testing::TestWithParam<Cameras> {
 protected:
  SteadyState() {
    SimulatorParameters parameters;
    parameters.width = 160;
    parameters.cameras = GetParam();
    FrameSetup setup;
    setup.scripts = read_scripts(std::filesystem::path(kSourceFolder) / "scripts");
    setup.behaviors = {"orientation", "background_training", "kidnap_recovery", "goal_search",
                       "wall_gaze",   "head_scan",           "get_up",          "penalty_marks"};
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
      simulator->answer(record.answer);
      inputs.external = {};
    }
  }

  std::optional<Simulator> simulator;
  std::optional<FrameLoop> engine;
  FrameInputs inputs;
};

TEST_P(SteadyState, AllocatesNothing) {
  EXPECT_EQ(allocations_when_steady({}), 0);
  EXPECT_GT(engine->record().world.confidence.coverage, 0.5) << "the frames should use all parts of the engine";
}

TEST_P(SteadyState, AllocatesNothingWithAllTopicsRequested) { EXPECT_EQ(allocations_when_steady(Topics::all()), 0); }

INSTANTIATE_TEST_SUITE_P(Cameras, SteadyState, testing::Values(Cameras::upper, Cameras::both),
                         [](const auto& each) { return each.param == Cameras::upper ? "upper" : "both"; });

}  // namespace
}  // namespace reorient
