// SPDX-License-Identifier: MIT
// Checks that the localization of a frame allocates no heap memory in the steady state.
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "localization/pose_filter.h"
#include "tests/localization/synthetic_field.h"

namespace {
std::size_t allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
// Not inlined, because the compiler would warn about free() of a pointer from operator new.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace reorient {
namespace {

TEST(PoseFilterMemory, IsNotAllocatedInTheSteadyStateNorByCommands) {
  PoseFilterParameters parameters;
  parameters.injection.known_goal_rate = 0.2;
  PoseFilter filter(parameters, FieldDimensions(), 1);
  const Pose2 start(2.0, 0.5, 0.0);
  filter.set_initial_pose(start, 0.1, 0.05);
  SyntheticField field(FieldDimensions(), PerceptErrors(), 1);
  std::vector<FieldPercept> percepts;
  percepts.reserve(60);
  for (int i = 0; i < 60; ++i) percepts.push_back(field.look(start, scanning_yaw(i / 30.0), i / 30.0));
  filter.update(percepts[0], SeenGoal::opponent);

  const std::size_t before = allocations;
  for (const FieldPercept& percept : percepts) {
    filter.predict({0.001, 0.0, 0.0}, 1.0 / 30.0);
    filter.update(percept, SeenGoal::opponent);
  }
  filter.flip_pose();
  filter.purge_reflection();
  filter.reset_orientation();
  EXPECT_EQ(allocations, before);
  EXPECT_GT(before, 0u);
}

TEST(PoseFilterMemory, IsNotAllocatedByALostRobotWithAView) {
  PoseFilter filter(PoseFilterParameters(), FieldDimensions(), 1);  // starts globally, so it is lost
  const Pose2 start(2.0, 0.5, 0.0);
  SyntheticField field(FieldDimensions(), PerceptErrors{.missed_posts = 1.0}, 1);
  const FieldPercept percept = field.look(start, 0.0, 0.0);
  const SeenView view{.azimuth = azimuth_from(start, 0.0, 8.0), .deviation = 0.2, .radius = 8.0, .direction = 0.0};
  const auto frame = [&] {
    filter.predict(Pose2(), 1.0 / 30.0);
    filter.update(percept, SeenGoal::unknown, view);
  };
  frame();
  const std::size_t before = allocations;
  frame();
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace reorient
