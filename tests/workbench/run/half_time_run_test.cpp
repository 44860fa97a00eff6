// SPDX-License-Identifier: MIT
// Poses at half-time: the operator uses the axes of the hall, all others use the team's.
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

using Kind = OperatorAction::Kind;

struct Hands : Operator {
  void pick_up() override {}
  void put_down(const Pose2& where) override { stands_at = where; }
  void push_over() override {}
  void penalize(bool) override {}
  void set_exposure_compensation(double) override {}
  void change_light() override {}

  std::optional<Pose2> stands_at;
};

class HalfTimeOfAScenario : public ::testing::Test {
 protected:
  void act(Kind kind, const Pose2& pose = {}) {
    carry_out({kind, pose, 0.0, false}, hands, external, sides_changed, referee);
  }

  static bool same(const Pose2& a, const Pose2& b) {
    return (a.position - b.position).norm() < 1e-9 && std::abs(angle_difference(a.rotation, b.rotation)) < 1e-9;
  }

  const Pose2 place{-3.0, 1.0, 0.5};
  Hands hands;
  ExternalInputs external;
  bool sides_changed = false;
  RefereeState referee;
};

TEST_F(HalfTimeOfAScenario, IsReportedAndRotatesLaterPoses) {
  act(Kind::put_down, place);
  EXPECT_TRUE(same(*hands.stands_at, place));
  act(Kind::half_time);
  EXPECT_TRUE(external.half_time);
  EXPECT_TRUE(sides_changed);
  act(Kind::put_down, place);
  EXPECT_TRUE(same(*hands.stands_at, reflect(place))) << "in the hall it is at the other end";
  act(Kind::set_initial_pose, place);
  EXPECT_TRUE(same(external.initial_pose->pose, place)) << "the robot plays towards that end";
}

TEST_F(HalfTimeOfAScenario, RotatesAPoseThatWasSetJustBefore) {
  act(Kind::set_initial_pose, place);
  act(Kind::half_time);
  EXPECT_TRUE(same(external.initial_pose->pose, reflect(place)));
}

TEST_F(HalfTimeOfAScenario, DoesNotChangeMessagesOfTeammates) {
  OperatorAction action{Kind::tell_message, {}, 0.0, false};
  action.message = {4, "I am at the center"};
  carry_out(action, hands, external, sides_changed, referee);
  act(Kind::half_time);
  ASSERT_EQ(external.messages.size(), 1u);
  EXPECT_EQ(external.messages[0].sender, 4);
  EXPECT_EQ(external.messages[0].text, "I am at the center");
}

TEST_F(HalfTimeOfAScenario, DoesNotChangeOtherInputsOfTheReferee) {
  referee = {false, GameState::playing, false, KickOff::theirs};
  OperatorAction action{Kind::stop_game, {}, 0.0, false};
  action.referee.stopped = true;
  carry_out(action, hands, external, sides_changed, referee);
  action = {Kind::penalize, {}, 0.0, true};
  carry_out(action, hands, external, sides_changed, referee);
  ASSERT_TRUE(external.referee);
  EXPECT_EQ(*external.referee, (RefereeState{true, GameState::playing, true, KickOff::theirs}));
}

TEST_F(HalfTimeOfAScenario, TwiceInOneFrameHasNoEffect) {
  act(Kind::half_time);
  act(Kind::half_time);
  EXPECT_FALSE(external.half_time);
  EXPECT_FALSE(sides_changed);
}

}  // namespace
}  // namespace reorient
