// SPDX-License-Identifier: MIT
#include "robots/companion/clock.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

TEST(ClientClock, StartsAtZeroForAnyTimeOfTheClientsClock) {
  ClientClock clock;
  const auto first = clock.advance(1, 1.7e9, Pose2(3.0, 2.0, 1.0), 0.0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->time, 0.0);
  EXPECT_NEAR(first->odometry.position.norm(), 0.0, 1e-12);
  const auto second = clock.advance(1, 1.7e9 + 0.5, Pose2(3.0, 2.0, 1.5), 0.5);
  EXPECT_NEAR(second->time, 0.5, 1e-6);
  EXPECT_NEAR(second->odometry.rotation, 0.5, 1e-12);
}

TEST(ClientClock, ContinuesAfterTheClientsProcessRestarted) {
  ClientClock clock;
  clock.advance(1, 100.0, Pose2(), 0.0);
  clock.advance(1, 101.0, Pose2(2.0, 0.0, 0.0), 1.0);
  const auto restarted = clock.advance(2, 5.0, Pose2(0.0, 0.0, 0.0), 3.0);
  ASSERT_TRUE(restarted);
  EXPECT_TRUE(clock.restarted());
  EXPECT_NEAR(restarted->time, 4.0, 1e-9) << "one second, and three seconds of silence";
  EXPECT_NEAR(restarted->odometry.position.x(), 2.0, 1e-12)
      << "the client's odometry restarts at zero, the engine's continues";
  const auto next = clock.advance(2, 5.1, Pose2(0.5, 0.0, 0.0), 0.1);
  EXPECT_FALSE(clock.restarted());
  EXPECT_NEAR(next->odometry.position.x(), 2.5, 1e-12);
}

TEST(ClientClock, DropsFramesThatAreNotAfterTheLast) {
  ClientClock clock;
  clock.advance(1, 10.0, Pose2(), 0.0);
  clock.advance(1, 11.0, Pose2(), 1.0);
  EXPECT_FALSE(clock.advance(1, 11.0, Pose2(), 0.03));
  EXPECT_FALSE(clock.advance(1, 10.5, Pose2(), 0.03));
  EXPECT_TRUE(clock.advance(1, 11.1, Pose2(), 0.03));
}

TEST(ClientClock, AcceptsAClockThatWasSetBackAfterASecond) {
  ClientClock clock;
  clock.advance(1, 1000.0, Pose2(), 0.0);
  clock.advance(1, 1001.0, Pose2(1.0, 0.0, 0.0), 1.0);
  int left_out = 0;
  std::optional<ClientClock::Moment> moment;
  for (int i = 1; i < 60 && !moment; ++i) {
    moment = clock.advance(1, 3.0 + i / 30.0, Pose2(1.0, 0.0, 0.0), 1.0 / 30.0);
    left_out += moment ? 0 : 1;
  }
  ASSERT_TRUE(moment);
  EXPECT_NEAR(left_out, 29, 1);
  EXPECT_NEAR(moment->time, 2.0, 0.05) << "the time of its silence is added";
  EXPECT_NEAR(moment->odometry.position.x(), 1.0, 1e-12) << "the odometry continues";
}

RC_GTEST_PROP(ClientClock, NeverGoesBack, ()) {
  ClientClock clock;
  double last = -1.0;
  for (int i = 0; i < 200; ++i) {
    const auto client = static_cast<std::uint64_t>(*rc::gen::inRange(1, 4));
    const double time = *rc::gen::element(-1e9, -5.0, 0.0, 0.1, 1.0, 7.5, 1e3, 1e6, 1e9) + 0.01 * i;
    const auto moment = clock.advance(client, time, Pose2(0.01 * i, 0.0, 0.0), *rc::gen::element(0.0, 0.03, 2.0, 1e6));
    if (!moment) continue;
    RC_ASSERT(moment->time > last);
    RC_ASSERT(std::isfinite(moment->time) && moment->odometry.position.allFinite());
    last = moment->time;
  }
}

}  // namespace
}  // namespace reorient
