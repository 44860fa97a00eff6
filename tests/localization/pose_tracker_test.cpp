// SPDX-License-Identifier: MIT
// Tracks one hypothesis together with the errors of the camera's angles.
#include "localization/tracking/pose_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "tests/localization/biased_camera.h"

namespace reorient {
namespace {

constexpr double kTrackedFrame = 1.0 / 30.0;  // s
const Pose2 kStandsAt(-1.5, 1.0, 0.4);

PoseBelief belief_at(const Pose2& pose) {
  PoseBelief belief;
  belief.pose = pose;
  belief.covariance.diagonal() << 0.01, 0.01, 0.003;
  belief.cluster_weight = 1.0;
  return belief;
}

/// A robot that stands and moves its head. The pose filter's belief is the tracker's.
struct Scanning {
  Scanning(const CameraBias& truth, std::uint64_t seed) : camera(truth, 0.7, seed), tracker({}, FieldDimensions()) {}

  void frame() {
    const HeadAngles head = scanning_head(time += kTrackedFrame);
    const CameraBias known = tracker.bias();
    const FieldPercept percept = camera.look(robot, head, known);
    tracker.predict(Pose2(), kTrackedFrame, MotionModelParameters());
    tracker.update({CameraPercept{&percept, corrected(BiasedCamera::measured(head), known, 0)}, CameraPercept{}},
                   tracker.belief(belief_at(robot)), kTrackedFrame);
  }
  void scan(double seconds) {
    for (const double end = time + seconds; time < end;) frame();
  }
  double position_error() const { return (tracker.belief(belief_at(robot)).pose.position - robot.position).norm(); }
  /// rad, error of the sum of the biases while the camera looks straight ahead.
  double pitch_error(const CameraBias& truth) const {
    const CameraBias known = tracker.bias();
    return std::abs(known.torso.pitch + known.mounts[0].pitch - truth.torso.pitch - truth.mounts[0].pitch);
  }

  Pose2 robot = kStandsAt;
  BiasedCamera camera;
  PoseTracker tracker;
  double time = 0.0;
};

CameraBias bias_of_degrees(double torso_roll, double torso_pitch, double mount_roll, double mount_pitch) {
  CameraBias bias;
  bias.torso = {from_degrees(torso_roll), from_degrees(torso_pitch)};
  bias.mounts[0] = {from_degrees(mount_roll), from_degrees(mount_pitch)};
  return bias;
}

class PoseTrackerOfABias : public testing::TestWithParam<std::array<double, 4>> {};

TEST_P(PoseTrackerOfABias, LearnsItAndTracksThePose) {
  const auto [torso_roll, torso_pitch, mount_roll, mount_pitch] = GetParam();
  const CameraBias truth = bias_of_degrees(torso_roll, torso_pitch, mount_roll, mount_pitch);
  Scanning scanning(truth, 1);
  scanning.tracker.attach(belief_at(Pose2(kStandsAt.position.x() + 0.1, kStandsAt.position.y(), kStandsAt.rotation)));
  scanning.scan(20.0);
  ASSERT_TRUE(scanning.tracker.is_attached());
  EXPECT_LT(scanning.position_error(), 0.06);
  EXPECT_LT(scanning.pitch_error(truth), from_degrees(0.4));
  EXPECT_LT(scanning.tracker.bias().deviation, from_degrees(0.5));
}

INSTANTIATE_TEST_SUITE_P(All, PoseTrackerOfABias,
                         testing::Values(std::array{0.0, 0.0, 0.0, 0.0}, std::array{0.0, 3.0, 0.0, 0.0},
                                         std::array{0.0, -3.0, 0.0, 0.0}, std::array{0.0, 0.0, 0.0, 3.0},
                                         std::array{0.0, 0.0, 0.0, -3.0}, std::array{2.0, 0.0, 0.0, 0.0},
                                         std::array{-2.0, 2.0, 1.0, 1.5}, std::array{0.0, 5.0, 0.0, 0.0}));

TEST(PoseTracker, ReportsADeviationThatContainsTheTruth) {
  double squares = 0.0, largest = 0.0;
  int frames = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Scanning scanning(bias_of_degrees(0.0, seed % 2 == 0 ? 2.0 : -2.0, 0.0, 0.5), seed);
    scanning.tracker.attach(belief_at(kStandsAt));
    scanning.scan(5.0);
    for (int i = 0; i < 300; ++i) {
      scanning.frame();
      const PoseBelief belief = scanning.tracker.belief(belief_at(scanning.robot));
      Eigen::Vector3d error;
      error << scanning.robot.position - belief.pose.position,
          angle_difference(scanning.robot.rotation, belief.pose.rotation);
      squares += error.dot(belief.covariance.inverse() * error);
      largest = std::max(largest, std::sqrt(belief.covariance.diagonal().head<2>().sum()));
      ++frames;
    }
  }
  const double normalized = squares / frames / 3.0;
  EXPECT_LT(normalized, 1.5);
  // The images of this test do not share errors, unlike those of a robot, so the deviation is too large.
  EXPECT_LT(largest, 0.1) << "m";
}

TEST(PoseTracker, TracksNothingBeforeItIsAttached) {
  Scanning scanning({}, 1);
  scanning.scan(3.0);
  EXPECT_FALSE(scanning.tracker.is_attached());
  const Pose2 elsewhere(1.0, 1.0, 0.0);
  EXPECT_EQ(scanning.tracker.belief(belief_at(elsewhere)).pose.position, elsewhere.position);
}

TEST(PoseTracker, StopsTrackingAWrongPoseAndForgetsTheBiasLearnedThere) {
  Scanning scanning({}, 1);
  scanning.tracker.attach(belief_at(Pose2(1.2, -1.7, 2.2)));
  scanning.scan(6.0);
  EXPECT_FALSE(scanning.tracker.is_attached());
  EXPECT_EQ(scanning.tracker.bias().torso.pitch, 0.0);
  EXPECT_EQ(scanning.tracker.bias().mounts[0].pitch, 0.0);
}

TEST(PoseTracker, StopsTrackingWhenThePoseFilterBelievesAnotherPose) {
  Scanning scanning({}, 1);
  scanning.tracker.attach(belief_at(kStandsAt));
  scanning.scan(2.0);
  ASSERT_TRUE(scanning.tracker.is_attached());
  const FieldPercept nothing;
  for (int i = 0; i < 30; ++i)
    scanning.tracker.update({CameraPercept{&nothing, BiasedCamera::measured({})}, CameraPercept{}},
                            belief_at(Pose2(2.0, -1.0, 0.0)), kTrackedFrame);
  EXPECT_FALSE(scanning.tracker.is_attached());
}

TEST(PoseTracker, KeepsTheLearnedBiasAfterAFall) {
  const CameraBias truth = bias_of_degrees(0.0, 3.0, 0.0, 0.0);
  Scanning scanning(truth, 1);
  scanning.tracker.attach(belief_at(kStandsAt));
  scanning.scan(15.0);
  scanning.tracker.doubt();
  EXPECT_FALSE(scanning.tracker.is_attached());
  EXPECT_LT(scanning.pitch_error(truth), from_degrees(0.5));
  scanning.tracker.set_bias({});
  EXPECT_EQ(scanning.tracker.bias().torso.pitch, 0.0);
}

TEST(PoseTracker, IsUnchangedAfterTwoFlips) {
  Scanning scanning(bias_of_degrees(0.0, 1.0, 0.0, 0.0), 1);
  scanning.tracker.attach(belief_at(kStandsAt));
  scanning.scan(3.0);
  const PoseBelief before = scanning.tracker.belief(belief_at(kStandsAt));
  scanning.tracker.flip();
  const PoseBelief flipped = scanning.tracker.belief(belief_at(reflect(kStandsAt)));
  EXPECT_NEAR((flipped.pose.position - reflect(before.pose).position).norm(), 0.0, 1e-12);
  EXPECT_EQ(flipped.covariance(0, 2), -before.covariance(0, 2));
  EXPECT_EQ(flipped.covariance(0, 1), before.covariance(0, 1));
  scanning.tracker.flip();
  EXPECT_NEAR(scanning.tracker.belief(belief_at(kStandsAt)).pose.rotation, before.pose.rotation, 1e-12);
}

TEST(PoseTracker, StaysFiniteWithAnyInput) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  PoseTracker tracker({}, FieldDimensions());
  tracker.attach(belief_at(kStandsAt));
  FieldPercept percept;
  for (const double value : {kNan, 0.0, 1e300, -1e300, std::numeric_limits<double>::infinity()}) {
    percept.line_points.push_back({{value, 1.0}, value, Eigen::Vector2f::Zero()});
    percept.goal_posts.push_back({{value, value}, true, Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()});
  }
  for (const double height : {0.5, 0.0, -1.0}) {
    Isometry3 camera = BiasedCamera::measured({});
    camera.translation().z() = height;
    tracker.predict({kNan, 0.0, 0.0}, kNan, MotionModelParameters());
    tracker.update({CameraPercept{&percept, camera}, CameraPercept{&percept, camera}}, belief_at(kStandsAt), 0.03);
  }
  const PoseBelief belief = tracker.belief(belief_at(kStandsAt));
  EXPECT_TRUE(belief.pose.position.allFinite());
  EXPECT_TRUE(belief.covariance.allFinite());
}

TEST(PoseTracker, ContinuesFromItsSavedState) {
  Scanning scanning(bias_of_degrees(0.0, 1.0, 0.0, 0.0), 1);
  scanning.tracker.attach(belief_at(kStandsAt));
  scanning.scan(8.0);
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  out(scanning.tracker);
  PoseTracker restored({}, FieldDimensions());
  ByteReader in(bytes);
  in(restored);
  EXPECT_TRUE(restored.is_attached());
  EXPECT_EQ(restored.bias().torso.pitch, scanning.tracker.bias().torso.pitch);
  EXPECT_EQ(restored.belief(belief_at(kStandsAt)).pose.rotation,
            scanning.tracker.belief(belief_at(kStandsAt)).pose.rotation);
}

}  // namespace
}  // namespace reorient
