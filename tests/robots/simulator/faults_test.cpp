// SPDX-License-Identifier: MIT
// Faults of a real robot and field: lost images, late answers, a camera with a tilt error, worn lines.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulator/simulator.h"
#include "tests/robots/simulator/shared_hall.h"

namespace reorient {
namespace {

Simulator simulator_with(void (*fault)(SimulatorParameters&)) {
  SimulatorParameters parameters;
  parameters.width = 160;
  parameters.tilt_error = 0.0;
  fault(parameters);
  return {parameters, RobotBody{}, FieldDimensions{}, shared_hall(), Pose2(-3.2, -3.5, kPi / 2.0), 1};
}

TEST(DroppedFrames, LeaveGapsInTimeButNotInTheBodysSamples) {
  Simulator simulator = simulator_with([](SimulatorParameters& p) { p.dropped_frames = 0.5; });
  Observation observation;
  simulator.observe(observation);
  double last = observation.time;
  std::size_t samples = 0;
  constexpr int kFrames = 300;
  for (int i = 0; i < kFrames; ++i) {
    simulator.observe(observation);
    EXPECT_GT(observation.time, last);
    last = observation.time;
    samples += observation.body_samples.size();
    EXPECT_NEAR(observation.body_samples.back().time, observation.time, 1e-9);
  }
  EXPECT_NEAR(last, 20.0, 2.0) << "300 of about 600 frames";
  EXPECT_NEAR(static_cast<double>(samples), 90.0 * last, 1.0);
}

/// Seconds from a request to walk until the robot has moved.
double reaction_time(Simulator simulator) {
  Observation observation;
  Answer answer;
  answer.request.walk = {0.2, 0.0, 0.0};
  for (int i = 0; i < 100; ++i) {
    simulator.observe(observation);
    if (observation.odometry.position.norm() > 1e-3) return observation.time;
    simulator.answer(answer);
  }
  return -1.0;
}

TEST(Latency, DelaysRequests) {
  const double at_once = reaction_time(simulator_with([](SimulatorParameters&) {}));
  const double late = reaction_time(simulator_with([](SimulatorParameters& p) { p.latency = 0.5; }));
  ASSERT_GT(at_once, 0.0);
  EXPECT_NEAR(late - at_once, 0.5, 0.05);
}

TEST(TiltOffset, IsUnknownToTheRobot) {
  Simulator straight = simulator_with([](SimulatorParameters&) {});
  Simulator bent = simulator_with([](SimulatorParameters& p) { p.tilt_offset = 0.035; });
  Observation observation, other;
  straight.observe(observation);
  bent.observe(other);
  const auto height_of_view = [](const Simulator& simulator) { return simulator.field_from_camera().linear()(2, 0); };
  EXPECT_NEAR(height_of_view(straight) - height_of_view(bent), 0.035, 2e-3) << "it really looks lower";
  EXPECT_TRUE(observation.upper->robot_from_camera.linear().isApprox(other.upper->robot_from_camera.linear(), 1e-9));
}

/// Fraction of the touchline's points that are white.
double white_share(const FieldLines& lines) {
  int white = 0, all = 0;
  for (double x = -4.4; x < 4.4; x += 0.01, ++all)
    white += lines.cover(static_cast<float>(x), 3.0f, 0.01f, 0.01f) > 0.5f;
  return static_cast<double>(white) / all;
}

TEST(WornLines, LackTheRequestedFraction) {
  EXPECT_EQ(white_share(FieldLines(FieldDimensions{})), 1.0);
  EXPECT_NEAR(white_share(FieldLines(FieldDimensions{}, 0.5)), 0.5, 0.2);
  EXPECT_EQ(white_share(FieldLines(FieldDimensions{}, 1.0)), 0.0);
}

}  // namespace
}  // namespace reorient
