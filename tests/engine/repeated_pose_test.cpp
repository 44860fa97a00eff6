// SPDX-License-Identifier: MIT
// A pose that is set again after the robot has flipped it rotates the learned room by 180 degrees.
#include "engine/world/repeated_pose.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "localization/reorientation.h"
#include "robots/simulator/simulator.h"
#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

const Pose2 kSetPose(-2.0, 1.0, 0.5);
constexpr RepeatedPoseParameters kParameters;

/// A pose was set at 10 s and flipped at 11 s.
RepeatedPose flipped_after(const Pose2& pose) {
  RepeatedPose repeated;
  EXPECT_FALSE(repeated.note_set(pose, {}, 10.0, kParameters));
  repeated.note_flip(11.0);
  return repeated;
}

TEST(RepeatedPose, UndoesAFlipIfThePoseIsSetFlippedAndSetAgain) {
  RepeatedPose repeated;
  EXPECT_FALSE(repeated.note_set(kSetPose, reflect(kSetPose), 10.0, kParameters)) << "no flip has happened";
  repeated.note_flip(11.0);
  EXPECT_TRUE(repeated.note_set(kSetPose, reflect(kSetPose), 15.0, kParameters));
}

TEST(RepeatedPose, CountsIfTheRobotHasMovedInBetween) {
  RepeatedPose repeated = flipped_after(kSetPose);
  EXPECT_TRUE(repeated.note_set({{-1.0, 2.0}, 1.5}, reflect(kSetPose), 15.0, kParameters));
}

TEST(RepeatedPose, CountsAtTheCenterOfTheField) {
  const Pose2 center({0.1, 0.0}, 0.0);
  RepeatedPose repeated = flipped_after(center);
  EXPECT_TRUE(repeated.note_set(center, Pose2({0.2, 0.1}, 3.0), 15.0, kParameters));
}

TEST(RepeatedPose, DoesNotCountIfTheRobotWasLiftedInBetween) {
  RepeatedPose repeated = flipped_after(kSetPose);
  repeated.forget();
  EXPECT_FALSE(repeated.note_set(kSetPose, reflect(kSetPose), 15.0, kParameters));
}

TEST(RepeatedPose, UndoesNothingWithoutASetPose) {
  RepeatedPose repeated;
  repeated.note_flip(11.0);
  EXPECT_FALSE(repeated.note_set(kSetPose, reflect(kSetPose), 15.0, kParameters));
}

TEST(RepeatedPose, ConfirmsTheFlipIfItIsNearTheBelief) {
  RepeatedPose repeated = flipped_after(kSetPose);
  EXPECT_FALSE(repeated.note_set(reflect(kSetPose), reflect(kSetPose), 15.0, kParameters));
}

TEST(RepeatedPose, UndoesNothingAfterTheTimeLimit) {
  for (const auto& [flipped, set] : {std::pair(11.0, 11.0 + kParameters.within), {10.0 + kParameters.within, 60.0}}) {
    RepeatedPose repeated;
    repeated.note_set(kSetPose, {}, 10.0, kParameters);
    repeated.note_flip(flipped);
    EXPECT_FALSE(repeated.note_set(kSetPose, reflect(kSetPose), set, kParameters)) << flipped << ", " << set;
  }
}

TEST(RepeatedPose, RestartsAfterARotationOfTheRoom) {
  RepeatedPose repeated = flipped_after(kSetPose);
  ASSERT_TRUE(repeated.note_set(kSetPose, reflect(kSetPose), 15.0, kParameters));
  repeated.note_flip(16.0);
  EXPECT_FALSE(repeated.note_set(kSetPose, reflect(kSetPose), 17.0, kParameters));
}

TEST(RepeatedPose, IsIgnoredIfTheTimeLimitIsZero) {
  RepeatedPose repeated;
  repeated.note_set(kSetPose, {}, 10.0, {.within = 0.0});
  repeated.note_flip(10.0);
  EXPECT_FALSE(repeated.note_set(kSetPose, reflect(kSetPose), 10.0, {.within = 0.0}));
}

/// A robot that learns the room while it believes the mirrored pose, and flips if a parameter requests it.
class LearnedMirrored : public ::testing::Test {
 protected:
  static constexpr const char* kTurnsAndFlips = R"(
    local p = param { flip = { false, doc = "whether the robot flips now" } }
    behavior "tested" { initial = "turning",
      update = function() walk.velocity(0, 0, 0.6) end,
      state "turning" { { "flipping", when = function() return p.flip end, because = "the parameter requests it" } },
      state "flipping" { enter = function() command.flip_pose() end,
        { "turning", when = function() return not p.flip end, because = "the flip is done" } } })";

  LearnedMirrored() : simulator_(parameters(), RobotBody(), FieldDimensions(), procedural_hall(1, {}), kSetPose, 1) {
    FrameSetup setup;
    setup.scripts.apply({"behaviors/tested.lua", ScriptText{kTurnsAndFlips, ""}});
    setup.behaviors.emplace_back("tested");
    engine_.emplace(std::move(setup));
    set(reflect(kSetPose));
    run(14.0);
  }
  static SimulatorParameters parameters() {
    SimulatorParameters parameters;
    parameters.width = 160;
    return parameters;
  }

  void set(const Pose2& pose) { inputs_.external.initial_pose = InitialPose{pose}; }
  void set_truth() { set(simulator_.ground_truth().pose); }
  void change(const std::string& name, const std::string& value) {
    inputs_.parameter_changes.emplace_back().name = name;
    inputs_.parameter_changes.back().value = value;
  }
  void flip() {
    change("tested.flip", "true");
    run(0.1);
    change("tested.flip", "false");
    run(0.1);
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(30.0 * seconds); ++i) {
      simulator_.observe(inputs_.observation);
      const FrameRecord& record = engine_->step(inputs_);
      for (const LogRecord& log : record.logs) notes_.push_back(log.text);
      simulator_.answer(record.answer);
      inputs_.external = {};
      inputs_.parameter_changes.clear();
    }
  }
  double evidence() const { return engine_->record().world.confidence.evidence; }

  Simulator simulator_;
  FrameInputs inputs_;
  std::optional<FrameLoop> engine_;
  std::vector<std::string> notes_;
};

TEST_F(LearnedMirrored, ContradictsTheTruePoseUntilThatIsSetAgain) {
  set_truth();
  run(3.0);
  EXPECT_GT(evidence(), 5.0) << "the learned room must be rotated by 180 degrees";
  flip();
  set_truth();
  run(3.0);
  EXPECT_LT(evidence(), -5.0);
  ASSERT_EQ(notes_.size(), 1u);
  EXPECT_NE(notes_.front().find("rotated by 180 degrees"), std::string::npos);
}

TEST_F(LearnedMirrored, KeepsItsRoomIfTheRobotWasLiftedBeforeThePoseIsSetAgain) {
  set_truth();
  run(3.0);
  flip();
  simulator_.pick_up();
  run(1.0);
  simulator_.put_down(simulator_.ground_truth().pose);
  run(2.0);
  set_truth();
  run(3.0);
  EXPECT_GT(evidence(), 5.0);
  EXPECT_TRUE(notes_.empty());
}

TEST_F(LearnedMirrored, ContinuesTheSameAfterASavedState) {
  set_truth();
  run(3.0);
  flip();
  std::vector<std::byte> state;
  engine_->save(state);
  engine_.emplace(std::span<const std::byte>(state));
  set_truth();
  run(3.0);
  EXPECT_LT(evidence(), -5.0);
}

}  // namespace
}  // namespace reorient
