// SPDX-License-Identifier: MIT
// Half-time: the axes rotate by 180 degrees, and everything known about the room with them.
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/bytes.h"
#include "perception/room/room_awareness.h"
#include "perception/room/view/azimuth.h"
#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

using test::PaintedRoom;
using test::ScanningRobot;

std::vector<std::byte> bytes_of(const RoomAwareness& room) {
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(room);
  return bytes;
}

RC_GTEST_PROP(Azimuth, RotationBy180DegreesIsExact, ()) {
  const double azimuth = to_azimuth(*rc::gen::arbitrary<double>());
  RC_PRE(std::isfinite(azimuth));
  RC_ASSERT(azimuth > -kPi && azimuth <= kPi);
  RC_ASSERT(to_azimuth(azimuth) == azimuth);
  const double other = opposite(azimuth);
  RC_ASSERT(other > -kPi && other <= kPi && to_azimuth(other) == other);
  RC_ASSERT(std::abs(std::abs(angle_difference(other, azimuth)) - kPi) < 1e-12);
  RC_ASSERT(opposite(other) == azimuth && std::signbit(opposite(other)) == std::signbit(azimuth));
}

TEST(Azimuth, OfEachOfTheFourSidesHasAnExactOpposite) {
  EXPECT_EQ(opposite(to_azimuth(0.0)), kPi);
  EXPECT_EQ(opposite(to_azimuth(-0.0)), kPi);
  EXPECT_EQ(opposite(to_azimuth(kPi)), 0.0);
  EXPECT_EQ(opposite(to_azimuth(-kPi)), 0.0);
  EXPECT_DOUBLE_EQ(opposite(to_azimuth(kPi / 2.0)), -kPi / 2.0);
  EXPECT_LT(std::abs(to_azimuth(0.1) - 0.1), 1e-15);
}

RC_GTEST_PROP(HalfTime, AppliedTwiceIsExactlyTheIdentity, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
  RoomParameters parameters;
  parameters.wall.columns = 2 * *rc::gen::inRange(2, 30);
  parameters.wall.rows = *rc::gen::inRange(1, 4);
  parameters.view_filter.method = *rc::gen::element(ViewMethod::particles, ViewMethod::grid);
  parameters.view_filter.cells = *rc::gen::inRange(8, 200);
  ScanningRobot robot(PaintedRoom::colorful(seed), parameters, seed);
  robot.run(*rc::gen::inRange(0, 8) / 10.0);
  const std::vector<std::byte> before = bytes_of(robot.awareness);
  robot.awareness.rotate_by_180_degrees();
  RC_ASSERT(bytes_of(robot.awareness) != before);
  robot.awareness.rotate_by_180_degrees();
  RC_ASSERT(bytes_of(robot.awareness) == before);
}

TEST(HalfTime, GivesTheModelThatIsLearnedFromRotatedPoses) {
  ScanningRobot robot(PaintedRoom::colorful(3), {}, 3), turned = robot;
  turned.belief = reflect(turned.truth);
  robot.run(10.0);
  turned.run(10.0);
  robot.awareness.rotate_by_180_degrees();
  for (int tile = 0; tile < robot.awareness.wall().tiles(); ++tile) {
    const TileModel& one = robot.awareness.model()[tile];
    const TileModel& other = turned.awareness.model()[tile];
    ASSERT_EQ(one.visits, other.visits) << tile;
    for (std::size_t bin = 0; bin < one.mean.size(); ++bin) {
      EXPECT_NEAR(one.mean[bin], other.mean[bin], 1e-3) << tile;
      EXPECT_NEAR(one.variance[bin], other.variance[bin], 1e-3) << tile;
    }
  }
}

TEST(HalfTime, DoesNotChangeTheConfidencesWithParticles) {
  RoomParameters parameters;
  parameters.view_filter.method = ViewMethod::particles;
  ScanningRobot robot(PaintedRoom::colorful(4), parameters, 4);
  robot.run(15.0);
  robot.train = false;
  ScanningRobot turned = robot;
  turned.awareness.rotate_by_180_degrees();
  turned.belief = reflect(turned.belief);
  EXPECT_EQ(turned.awareness.confidences().current, robot.awareness.confidences().current);
  EXPECT_EQ(turned.awareness.confidences().age, robot.awareness.confidences().age);
  for (int frame = 0; frame < 30; ++frame) {
    robot.run(1.0 / 15.0);
    turned.run(1.0 / 15.0);
    const Confidences& before = robot.awareness.confidences();
    const Confidences& after = turned.awareness.confidences();
    ASSERT_EQ(after.raw_current, before.raw_current) << frame;
    ASSERT_EQ(after.raw_opposite, before.raw_opposite) << frame;
    ASSERT_EQ(after.current, before.current) << frame;
    ASSERT_EQ(after.opposite, before.opposite) << frame;
    ASSERT_EQ(after.goal_own, before.goal_opponent) << frame;
    ASSERT_EQ(after.goal_opponent, before.goal_own) << frame;
    ASSERT_EQ(after.coverage, before.coverage) << frame;
    ASSERT_NEAR(after.evidence, before.evidence, 1e-6) << frame;
    ASSERT_NEAR(after.distinctiveness, before.distinctiveness, 1e-6) << frame;
  }
}

TEST(HalfTime, DoesNotChangeTheConfidencesWithAGrid) {
  ScanningRobot robot(PaintedRoom::colorful(4), {}, 4);
  robot.run(15.0);
  robot.train = false;
  ScanningRobot turned = robot;
  turned.awareness.rotate_by_180_degrees();
  turned.belief = reflect(turned.belief);
  ASSERT_GT(robot.awareness.confidences().current, 0.5);
  for (int frame = 0; frame < 30; ++frame) {
    robot.run(1.0 / 15.0);
    turned.run(1.0 / 15.0);
    const Confidences& before = robot.awareness.confidences();
    const Confidences& after = turned.awareness.confidences();
    ASSERT_NEAR(after.raw_current, before.raw_current, 1e-9) << frame;
    ASSERT_NEAR(after.raw_opposite, before.raw_opposite, 1e-9) << frame;
    ASSERT_NEAR(after.goal_own, before.goal_opponent, 1e-9) << frame;
  }
}

TEST(HalfTime, RotatesTheViewParticlesWithTheWall) {
  RoomParameters parameters;
  parameters.view_filter.method = ViewMethod::particles;
  ScanningRobot robot(PaintedRoom::colorful(5), parameters, 5);
  robot.run(5.0);
  ASSERT_FALSE(robot.awareness.view_filter().particles().empty());
  const std::vector<ViewParticle> before(robot.awareness.view_filter().particles().begin(),
                                         robot.awareness.view_filter().particles().end());
  const std::optional<double> center = robot.awareness.center_of_view();
  ASSERT_TRUE(center);
  robot.awareness.rotate_by_180_degrees();
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(robot.awareness.view_filter().particles()[i].azimuth, opposite(before[i].azimuth));
    EXPECT_EQ(robot.awareness.view_filter().particles()[i].weight, before[i].weight);
  }
  EXPECT_EQ(robot.awareness.center_of_view(), opposite(*center));
}

}  // namespace
}  // namespace reorient
