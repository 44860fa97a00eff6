// SPDX-License-Identifier: MIT
// The guard and the body of a NAO, in simulated time.
#include "robots/nao/guard/guard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {
namespace {

class GuardTest : public testing::Test {
 protected:
  GuardTest() { guard_.connected(); }
  ~GuardTest() override { EXPECT_EQ(body_.complaint(), ""); }

  /// Runs for some seconds; while the engine lives, it writes a request every third cycle.
  void run(double seconds) {
    for (double end = time_ + seconds; time_ < end; time_ += kCycle) {
      if (engine_lives_ && ++cycle_ % 3 == 0) {
        asked_ = request_;
        asked_->time = time_;
      }
      if (walk_lives_) walk_.time = time_;
      Measurement measurement = body_.measurement();
      measurement.time = time_;
      measurement.fresh &= ~missing_;
      const std::optional<Command> command = guard_.step(measurement, body_.identity(), asked_, walk_);
      if (command) {
        body_.take(*command);
        last_ = *command;
      }
      body_.step();
    }
  }
  /// The engine requests to sit until the button is pressed.
  void press_button() {
    request_.posture = WantedPosture::sit;
    run(0.1);
    request_.posture = WantedPosture::stand;
  }
  void stand() {
    press_button();
    run(3.5);
    ASSERT_EQ(guard_.state(), GuardState::standing);
  }

  void walk() {
    walk_lives_ = true;
    walk_.moves_joints = 1;
    walk_.joints = standing_posture();
    walk_.stiffness.fill(0.9f);
    walk_.joints[kLeftKneePitch] = 0.9f;
  }

  Guard guard_;
  TwinBody body_;
  BodyRequest request_;
  std::optional<BodyRequest> asked_;
  bool engine_lives_ = true;
  WalkTargets walk_;
  bool walk_lives_ = false;
  std::uint32_t missing_ = 0;
  double time_ = 100.0;
  int cycle_ = 0;
  Command last_;
};

TEST_F(GuardTest, StartsWithSoftJointsAtTheMeasuredPositions) {
  const JointValues before = body_.measurement().position;
  run(1.0);
  EXPECT_EQ(last_.position, before);
  EXPECT_TRUE(body_.is_soft());
}

TEST_F(GuardTest, StandsUpAndSitsDownAgain) {
  stand();
  EXPECT_TRUE(body_.stands());
  request_.posture = WantedPosture::sit;
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
  EXPECT_TRUE(body_.sits());
  EXPECT_TRUE(body_.is_soft());
  EXPECT_EQ(body_.falls(), 0);
}

TEST_F(GuardTest, SitsDownBeforeItBecomesSoft) {
  stand();
  request_.posture = WantedPosture::soft;
  run(1.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting_down);
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::soft);
  EXPECT_EQ(body_.falls(), 0);
}

TEST_F(GuardTest, SitsDownOneSecondAfterTheLastRequest) {
  stand();
  engine_lives_ = false;
  run(0.95);
  EXPECT_EQ(guard_.state(), GuardState::standing);
  EXPECT_NE(guard_.warnings() & kNoRequest, 0u);
  run(0.15);
  EXPECT_EQ(guard_.state(), GuardState::sitting_down);
  run(2.5);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
  EXPECT_TRUE(body_.sits());
}

TEST_F(GuardTest, StaysDownWhenRequestsReturnUntilOneForAnotherPosture) {
  stand();
  engine_lives_ = false;
  run(6.0);
  ASSERT_EQ(guard_.state(), GuardState::sitting);
  EXPECT_EQ(guard_.warnings() & kStandRefused, 0u);
  engine_lives_ = true;  // it continues with its last request
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
  EXPECT_NE(guard_.warnings() & kStandRefused, 0u);
  request_.posture = static_cast<WantedPosture>(77);
  run(0.2);
  request_.posture = WantedPosture::stand;
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting) << "an invalid request does not count";
  stand();
  EXPECT_EQ(guard_.warnings() & kStandRefused, 0u);
}

TEST_F(GuardTest, StaysDownAfterItsOwnRestartUntilARequestForAnotherPosture) {
  stand();
  request_.posture = WantedPosture::sit;
  run(4.0);
  request_.posture = WantedPosture::stand;
  guard_ = Guard();
  guard_.connected();
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::soft);
  EXPECT_NE(guard_.warnings() & kStandRefused, 0u);
  stand();
}

TEST_F(GuardTest, HoldsAStandingRobotAfterItsOwnRestart) {
  stand();
  guard_ = Guard();
  guard_.connected();
  asked_.reset();  // the shared memory is empty
  engine_lives_ = false;
  run(0.9);
  EXPECT_EQ(guard_.state(), GuardState::standing_up) << "it stands, and the engine needs a moment";
  engine_lives_ = true;
  run(3.0);
  EXPECT_EQ(guard_.state(), GuardState::standing);
  EXPECT_TRUE(body_.stands());
  guard_ = Guard();
  guard_.connected();
  asked_.reset();
  engine_lives_ = false;
  run(1.2);
  EXPECT_EQ(guard_.state(), GuardState::sitting_down) << "no engine runs";
}

TEST_F(GuardTest, StopsTheHeadHalfASecondAfterTheLastRequest) {
  stand();
  request_.moves_head = 1;
  request_.head_yaw = 2.0f;
  request_.head_speed = 1.0f;
  run(0.2);
  engine_lives_ = false;
  run(0.45);
  const float still_moves = last_.position[kHeadYaw];
  run(0.1);
  const float stopped = last_.position[kHeadYaw];
  EXPECT_GT(stopped, still_moves);
  run(0.3);
  EXPECT_EQ(last_.position[kHeadYaw], stopped);
  EXPECT_LT(stopped, 1.0f);
}

TEST_F(GuardTest, TurnsTheHeadAtMostAtTheRequestedSpeedAndNeverIntoTheShoulders) {
  stand();
  request_.moves_head = 1;
  request_.head_yaw = 1.5f;
  request_.head_pitch = 0.5f;
  request_.head_speed = 0.5f;
  run(1.0);
  EXPECT_NEAR(last_.position[kHeadYaw], 0.5f, 0.03f);
  request_.head_speed = 100.0f;
  run(1.0);
  EXPECT_NEAR(last_.position[kHeadYaw], 1.5f, 1e-3f);
  EXPECT_NEAR(last_.position[kHeadPitch], head_pitch_range(1.5f).most, 1e-3f);
}

TEST_F(GuardTest, TurnsTheHeadOfASittingRobot) {
  stand();
  request_.posture = WantedPosture::sit;
  request_.moves_head = 1;
  request_.head_yaw = -1.0f;
  request_.head_speed = 2.0f;
  run(5.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
  EXPECT_NEAR(body_.measurement().position[kHeadYaw], -1.0f, 1e-3f);
}

TEST_F(GuardTest, NeitherStandsUpNorSitsDownWhileHeldAtATilt) {
  body_.tilt(0.3f, 0.0f);
  press_button();
  run(2.0);
  EXPECT_EQ(guard_.state(), GuardState::soft);
  EXPECT_NE(guard_.warnings() & kTilted, 0u);
  body_.tilt(0.0f, 0.0f);
  stand();
  body_.tilt(0.0f, 0.4f);
  engine_lives_ = false;
  run(3.0);
  EXPECT_EQ(guard_.state(), GuardState::standing) << "an operator holds it at a tilt";
  body_.tilt(0.0f, 0.0f);
  run(3.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
}

TEST_F(GuardTest, BecomesSoftAtOnceInAFallAndStaysSoft) {
  stand();
  body_.push();
  run(0.4);
  EXPECT_EQ(guard_.state(), GuardState::fallen);
  EXPECT_TRUE(body_.is_soft());
  run(2.0);
  body_.pick_up_and_put_down();
  run(2.0);
  EXPECT_EQ(guard_.state(), GuardState::fallen) << "standing was requested before it fell";
  request_.posture = WantedPosture::sit;
  run(0.1);
  EXPECT_EQ(guard_.state(), GuardState::soft);
  stand();
}

TEST_F(GuardTest, SitsDownIfAMotorIsTooHot) {
  body_.set_status(1.0f);
  stand();
  EXPECT_NE(guard_.warnings() & kHot, 0u);
  EXPECT_EQ(guard_.warning_joint(), static_cast<std::uint32_t>(kLeftKneePitch));
  body_.set_status(2.0f);
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
  body_.set_status(1.0f);
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting) << "it is only a little cooler";
  body_.set_status(0.0f);
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::standing);
}

TEST_F(GuardTest, SitsDownWithAnEmptyBatteryButNotWithAnUnknownCharge) {
  body_.set_charge(0.0f);
  stand();
  body_.set_charge(0.08f);
  run(1.0);
  EXPECT_EQ(guard_.state(), GuardState::standing);
  EXPECT_NE(guard_.warnings() & kBatteryLow, 0u);
  body_.set_charge(0.04f);
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
}

TEST_F(GuardTest, SitsDownIfALegDoesNotReachItsTarget) {
  body_.block(kLeftKneePitch);
  press_button();
  run(4.0);
  EXPECT_NE(guard_.warnings() & kJointStuck, 0u);
  EXPECT_EQ(guard_.warning_joint(), static_cast<std::uint32_t>(kLeftKneePitch));
  run(2.0);
  EXPECT_NE(guard_.warnings() & kJointGivenUp, 0u);
  EXPECT_EQ(guard_.state(), GuardState::sitting_down);
}

TEST_F(GuardTest, LetsAHeldHeadYieldWithoutSittingDown) {
  stand();
  body_.block(kHeadYaw);
  request_.moves_head = 1;
  request_.head_yaw = 1.5f;
  request_.head_speed = 3.0f;
  run(6.0);
  EXPECT_EQ(guard_.state(), GuardState::standing);
  EXPECT_LT(last_.position[kHeadYaw], 0.4f);
}

TEST_F(GuardTest, HoldsItsPostureWithoutPositionsAndAngles) {
  stand();
  missing_ = 1u << static_cast<unsigned>(SensorKey::angles);
  request_.posture = WantedPosture::sit;
  run(2.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting_down) << "it started before the values were missing long enough";
  missing_ = 0;
  run(3.0);
  stand();
  missing_ = 1u << static_cast<unsigned>(SensorKey::position);
  run(0.2);
  request_.posture = WantedPosture::sit;
  run(3.0);
  EXPECT_EQ(guard_.state(), GuardState::standing);
  EXPECT_NE(guard_.warnings() & kBlind, 0u);
}

TEST_F(GuardTest, DoesNotMoveABodyOfAnotherVersion) {
  RobotIdentity other = body_.identity();
  other.body_version[0] = '5';
  for (int i = 0; i < 200; ++i) {
    request_.posture = i < 10 ? WantedPosture::sit : WantedPosture::stand;
    Measurement measurement = body_.measurement();
    measurement.time = request_.time = 1.0 + i * kCycle;
    const std::optional<Command> command = guard_.step(measurement, other, request_);
    ASSERT_TRUE(command);
    EXPECT_EQ(*std::max_element(command->stiffness.begin(), command->stiffness.end()), 0.0f);
  }
  EXPECT_EQ(guard_.state(), GuardState::soft);
  EXPECT_EQ(guard_.warnings() & kStandRefused, 0u);
}

TEST_F(GuardTest, TakesOverAStandingBody) {
  stand();
  guard_.connected();
  run(0.012);
  EXPECT_NE(guard_.state(), GuardState::soft);
  run(3.0);
  EXPECT_EQ(guard_.state(), GuardState::standing);
  EXPECT_EQ(body_.falls(), 0);
}

TEST_F(GuardTest, DoesNotPassInvalidRequestsToTheJoints) {
  stand();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  request_.moves_head = 0x7fff;
  request_.head_yaw = request_.head_pitch = request_.head_speed = nan;
  walk_lives_ = true;
  walk_.moves_joints = 1;
  walk_.joints.fill(nan);
  walk_.stiffness.fill(1e9f);
  request_.lights.chest.red = nan;
  request_.lights.left_ear[3] = 7.0f;
  run(1.0);
  EXPECT_EQ(last_.lights.chest.red, 0.0f);
  EXPECT_EQ(last_.lights.left_ear[3], 1.0f);
  request_.posture = static_cast<WantedPosture>(77);
  run(4.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
}

TEST_F(GuardTest, FollowsAWalkWithinTheJointsSpeedAndHoldsIfItIsSilent) {
  stand();
  walk();
  run(1.0);
  EXPECT_NEAR(body_.measurement().position[kLeftKneePitch], 0.9f, 1e-3f);
  engine_lives_ = false;
  run(0.3);
  walk_.joints[kLeftKneePitch] = 0.8f;
  run(0.6);
  EXPECT_NEAR(last_.position[kLeftKneePitch], 0.9f, 1e-3f) << "it must not continue without the engine";
  engine_lives_ = true;
  walk_.moves_joints = 0;
  run(1.5);
  EXPECT_NEAR(last_.position[kLeftKneePitch], standing_posture()[kLeftKneePitch], 1e-3f);
}

TEST_F(GuardTest, ReturnsToStandingAfterAWalkEnded) {
  stand();
  walk();
  run(1.0);
  walk_lives_ = false;
  run(0.4);
  EXPECT_NEAR(last_.position[kLeftKneePitch], 0.9f, 1e-3f) << "it holds its posture";
  run(2.0);
  EXPECT_NEAR(last_.position[kLeftKneePitch], standing_posture()[kLeftKneePitch], 1e-3f);
  EXPECT_EQ(guard_.state(), GuardState::standing);
}

TEST_F(GuardTest, IgnoresAWalkWhileItSits) {
  walk();
  run(2.0);
  EXPECT_TRUE(body_.is_soft());
  EXPECT_EQ(guard_.state(), GuardState::soft);
}

TEST_F(GuardTest, SitsDownAndBecomesSoftBeforeItEnds) {
  stand();
  guard_.finish();
  EXPECT_FALSE(guard_.is_at_rest());
  run(4.0);
  EXPECT_TRUE(guard_.is_at_rest());
  EXPECT_TRUE(body_.sits());
  EXPECT_EQ(body_.falls(), 0);
}

TEST_F(GuardTest, BecomesSoftIfItIsTiltedWhenTheGuardIsStopped) {
  stand();
  body_.tilt(0.4f, 0.0f);
  guard_.finish();
  run(4.5);
  EXPECT_EQ(guard_.state(), GuardState::standing)
      << "it would fall if it became soft before the operator puts it upright";
  EXPECT_FALSE(body_.is_soft());
  run(2.0);
  EXPECT_TRUE(guard_.is_at_rest());
  EXPECT_TRUE(body_.is_soft());
}

TEST_F(GuardTest, MakesTheHeadSoftWithoutRequests) {
  stand();
  engine_lives_ = false;
  run(5.0);
  EXPECT_EQ(guard_.state(), GuardState::sitting);
  EXPECT_EQ(last_.stiffness[kHeadYaw], 0.0f);
  EXPECT_EQ(last_.stiffness[kHeadPitch], 0.0f);
  engine_lives_ = true;
  request_.posture = WantedPosture::sit;
  request_.moves_head = 1;
  request_.head_yaw = 0.5f;
  request_.head_speed = 2.0f;
  run(2.0);
  EXPECT_NEAR(body_.measurement().position[kHeadYaw], 0.5f, 0.01f) << "requests have returned";
}

TEST_F(GuardTest, ShowsThatRequestsAreMissingAndNotTheLastLightsOfTheEngine) {
  constexpr Lights::Color kDark, kGreen{0.0f, 1.0f, 0.0f};
  request_.lights.left_eye.fill(kGreen);
  request_.lights.skull.fill(1.0f);
  stand();
  EXPECT_EQ(last_.lights.left_eye[0], kGreen);
  engine_lives_ = false;
  run(0.5);
  EXPECT_EQ(last_.lights.chest, (Lights::Color{1.0f, 0.6f, 0.0f}));
  EXPECT_EQ(last_.lights.left_eye[0], kDark);
  EXPECT_EQ(last_.lights.skull[0], 0.0f);
}

TEST_F(GuardTest, IsDarkWhenItEnds) {
  request_.lights.chest = request_.lights.right_eye[3] = {0.0f, 1.0f, 0.0f};
  stand();
  guard_.finish();
  run(4.0);
  ASSERT_TRUE(guard_.is_at_rest());
  EXPECT_EQ(last_.lights.chest, Lights::Color());
  EXPECT_EQ(last_.lights.right_eye[3], Lights::Color());
}

TEST(Postures, AreWithinTheJointsLimitsAndSymmetric) {
  for (const JointValues* const posture : {&standing_posture(), &crouching_posture(), &sitting_posture()}) {
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      EXPECT_GE((*posture)[joint], kJointLimits[joint].least) << joint;
      EXPECT_LE((*posture)[joint], kJointLimits[joint].most) << joint;
    }
    EXPECT_EQ((*posture)[kLeftKneePitch], (*posture)[kRightKneePitch]);
    EXPECT_EQ((*posture)[kLeftShoulderRoll], -(*posture)[kRightShoulderRoll]);
  }
}

}  // namespace
}  // namespace reorient::nao
