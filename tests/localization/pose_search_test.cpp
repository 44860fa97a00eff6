// SPDX-License-Identifier: MIT
// A robot that does not know its pose, with an unknown error of its camera's angles.
#include "localization/search/pose_search.h"

#include <vector>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "tests/localization/biased_camera.h"

namespace reorient {
namespace {

constexpr double kSearchFrame = 1.0 / 30.0;  // s

BiasPrior usual_prior() { return {{}, from_degrees(3.0), from_degrees(2.0)}; }

struct Searching {
  Searching(const CameraBias& truth, const Pose2& where, std::uint64_t seed)
      : robot(where), camera(truth, 0.7, seed), search({}, FieldDimensions(), seed) {}

  std::optional<PoseHypothesis> frame() {
    const HeadAngles head = scanning_head(time += kSearchFrame);
    search.see(camera.look(robot, head, {}), 0, BiasedCamera::measured(head), {}, odometry, time);
    return search.search(map, usual_prior(), odometry, {});
  }
  std::optional<PoseHypothesis> within(double seconds) {
    for (const double end = time + seconds; time < end;) {
      if (auto found = frame()) return found;
    }
    return std::nullopt;
  }

  Pose2 robot;
  Pose2 odometry{3.0, -2.0, 1.0};
  BiasedCamera camera;
  FieldMap map{FieldDimensions()};
  PoseSearch search;
  double time = 100.0;
};

class PoseSearchFrom : public testing::TestWithParam<std::uint64_t> {};

TEST_P(PoseSearchFrom, AnywhereFindsPoseAndTilt) {
  Random random(GetParam(), 9);
  const Pose2 where(random.uniform(-3.5, 3.5), random.uniform(-2.0, 2.0), random.uniform(-kPi, kPi));
  CameraBias truth;
  truth.torso.pitch = from_degrees(random.uniform(-3.0, 3.0));
  truth.mounts[0].pitch = from_degrees(random.uniform(-1.5, 1.5));
  Searching robot(truth, where, GetParam());
  robot.camera.false_points = 0.05;
  const std::optional<PoseHypothesis> found = robot.within(10.0);
  ASSERT_TRUE(found);
  const Pose2 pose = found->field_from_odometry * robot.odometry;
  const Pose2 reflected = reflect(where);
  const Pose2& nearer =
      (pose.position - where.position).norm() < (pose.position - reflected.position).norm() ? where : reflected;
  EXPECT_LT((pose.position - nearer.position).norm(), 0.3);
  EXPECT_LT(std::abs(angle_difference(pose.rotation, nearer.rotation)), from_degrees(8.0));
}

INSTANTIATE_TEST_SUITE_P(Seeds, PoseSearchFrom, testing::Range<std::uint64_t>(1, 13));

TEST(PoseSearch, FindsNothingFromASingleLine) {
  Searching robot({}, Pose2(0.0, 2.9, kPi / 2.0), 1);  // in front of the touchline, looking out of the field
  EXPECT_FALSE(robot.within(3.0));
}

TEST(PoseSearch, FindsTheNewPoseAfterOldSightingsAreDeleted) {
  Searching robot({}, Pose2(-2.0, 1.0, 0.0), 1);
  ASSERT_TRUE(robot.within(8.0));
  robot.robot = Pose2(1.5, -1.5, 2.0);
  robot.search.forget_before(robot.time);
  const std::optional<PoseHypothesis> found = robot.within(8.0);
  ASSERT_TRUE(found);
  const Pose2 pose = found->field_from_odometry * robot.odometry;
  EXPECT_NEAR(std::abs(pose.position.x()), 1.5, 0.3);
  EXPECT_NEAR(std::abs(pose.position.y()), 1.5, 0.3);
}

TEST(PoseSearch, ContinuesFromItsSavedState) {
  Searching robot({}, Pose2(-2.0, 1.0, 0.0), 1);
  for (int i = 0; i < 20; ++i) robot.frame();
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  out(robot.search);
  Searching restored({}, Pose2(-2.0, 1.0, 0.0), 1);
  ByteReader in(bytes);
  in(restored.search);
  restored.time = robot.time;
  restored.camera = robot.camera;
  const auto a = robot.within(8.0), b = restored.within(8.0);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->field_from_odometry.position, b->field_from_odometry.position);
  EXPECT_EQ(a->cost, b->cost);
}

TEST(PoseSearch, FindsNothingFromValuesThatAreNotFinite) {
  const FieldMap map{FieldDimensions()};
  PoseSearch search({}, FieldDimensions(), 1);
  FieldPercept percept;
  for (int i = 0; i < 20; ++i) percept.line_points.push_back({{std::nan(""), 1.0}, 0.0, Eigen::Vector2f::Zero()});
  for (int i = 0; i < 60; ++i) {
    search.see(percept, 0, BiasedCamera::measured({}), {}, {}, i * kSearchFrame);
    EXPECT_FALSE(search.search(map, usual_prior(), {}, {}));
  }
}

}  // namespace
}  // namespace reorient
