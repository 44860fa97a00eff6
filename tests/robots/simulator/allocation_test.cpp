// SPDX-License-Identifier: MIT
// In the steady state a frame of the simulator allocates no memory, in any light and with any lens.
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "robots/simulator/simulator.h"

namespace {

bool counting = false;
long allocations = 0;

void* allocate(std::size_t size) {
  if (counting) ++allocations;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Not inlined, because the compiler would warn that a pointer of operator new is freed.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace reorient {
namespace {

TEST(SimulatorInSteadyState, AllocatesNothingInHardLight) {
  SimulatorParameters parameters;
  parameters.width = 160;
  parameters.light = {0.5, 0.18, 0.06, 15.0, 1.0, 0.8, 150.0, 1.0, 0.35, 0.2, 3.5, 0.5, 5.0};
  parameters.sensor.blur_angle = 0.003;
  parameters.sensor.exposure_time = 0.01;
  parameters.sensor.readout_time = 0.028;
  parameters.sensor.noise_gain = 1.0;
  const Room room = procedural_hall(1, RoomShape{});
  Simulator simulator(parameters, RobotBody(), FieldDimensions{}, room, Pose2(-3.2, -3.5, 0.5 * kPi), 1);
  Observation observation;
  const auto frame = [&](int number) {
    Answer answer;
    answer.request.head = HeadRequest{{number % 60 < 30 ? 1.0 : -1.0, 0.1}, 3.0};
    simulator.answer(answer);
    simulator.observe(observation);
  };
  simulator.change_light();
  for (int i = 0; i < 90; ++i) frame(i);
  counting = true;
  for (int i = 90; i < 150; ++i) frame(i);
  counting = false;
  EXPECT_EQ(allocations, 0);
}

}  // namespace
}  // namespace reorient
