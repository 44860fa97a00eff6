// SPDX-License-Identifier: MIT
// Counts allocations: room awareness allocates nothing after a few frames.
#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "tests/perception/room/painted_room.h"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// Not inlined: otherwise the compiler sees that a pointer of operator new is freed, and warns.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace reorient {
namespace {

TEST(Memory, FramesAllocateNothingInTheSteadyState) {
  RoomParameters by_particles;
  by_particles.view_filter.method = ViewMethod::particles;
  for (const RoomParameters& parameters : {RoomParameters{}, test::paper_recipe(), by_particles}) {
    test::ScanningRobot robot(test::PaintedRoom::colorful(1), parameters, 1);
    const std::vector<CoveredArea> covered = {{20, 30, 60, 119}};
    long during_updates = 0;
    for (int frame = 0; frame < 300; ++frame) {
      RoomObservation view = robot.look();
      view.covered = covered;
      const long before = allocations;
      robot.awareness.update(view);
      if (frame == 150) robot.awareness.on_flip();
      if (frame > 0) during_updates += allocations - before;
      robot.time += 1.0 / 15.0;
      robot.truth.rotation += 0.01;
      robot.belief = frame < 150 ? robot.truth : reflect(robot.truth);
    }
    EXPECT_EQ(during_updates, 0);
    EXPECT_GT(robot.awareness.confidences().coverage, 0.5);
  }
}

}  // namespace
}  // namespace reorient
