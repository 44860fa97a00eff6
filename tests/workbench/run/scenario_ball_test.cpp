// SPDX-License-Identifier: MIT
// The ball of a simulator in scenarios: the operator places it, and scenarios read its true position and the score.
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

class BallOperator : public Operator {
 public:
  void pick_up() override {}
  void put_down(const Pose2& /*where*/) override {}
  void push_over() override {}
  void penalize(bool /*penalized*/) override {}
  void set_exposure_compensation(double /*stops*/) override {}
  void change_light() override {}
  void put_ball(const Eigen::Vector2d& where) override { ball = where; }

  std::optional<Eigen::Vector2d> ball;
};

/// The record of a scenario that runs `statement` once.
ScenarioRecord record_of(const std::string& statement, const std::optional<BallTruth>& ball) {
  ScriptTexts texts;
  const std::string script =
      "scenario \"one\" { initial = \"a\", state \"a\" { enter = function() " + statement + " end } }";
  texts.apply({"scenarios/one.lua", ScriptText{script, ""}});
  RecordedBehaviors behaviors;
  ScenarioHost host(texts, "scenarios/one.lua", {}, behaviors);
  const World world;
  const ApplicationRecord application;
  return host.tick({world, application, std::nullopt, ball});
}

std::string fault_of_ball(const std::string& statement) {
  const ScenarioRecord record = record_of(statement, std::nullopt);
  return record.faults.empty() ? "" : record.faults.front().fault.message;
}

TEST(ScenarioBall, IsPlacedByTheOperatorInTheAxesOfTheTeam) {
  const ScenarioRecord record = record_of("operator.put_ball(1.5, -0.5)", std::nullopt);
  ASSERT_EQ(record.actions.size(), 1u);
  BallOperator the_operator;
  ExternalInputs external;
  bool sides_changed = false;
  carry_out(record.actions[0], the_operator, external, sides_changed, {});
  EXPECT_EQ(the_operator.ball.value(), Eigen::Vector2d(1.5, -0.5));
  sides_changed = true;
  carry_out(record.actions[0], the_operator, external, sides_changed, {});
  EXPECT_EQ(the_operator.ball.value(), Eigen::Vector2d(-1.5, 0.5));
}

TEST(ScenarioBall, IsNotPlacedFarFromTheField) {
  for (const std::string place : {"(101, 0)", "(0, -1e308)"}) {
    const std::string fault = fault_of_ball("operator.put_ball" + place);
    EXPECT_NE(fault.find("operator.put_ball: expected a pose within 100 m"), std::string::npos) << place << fault;
  }
  for (const std::string place : {"(0/0, 0)", "(0, math.huge)"})
    EXPECT_NE(fault_of_ball("operator.put_ball" + place).find("finite number expected"), std::string::npos) << place;
  EXPECT_NE(fault_of_ball("operator.put_ball(1)"), "");
  EXPECT_NE(fault_of_ball("operator.put_ball('here', 2)"), "");
}

TEST(ScenarioBall, IsReadAsTruth) {
  const BallTruth ball{{2.5, -1.25}, 3, 1};
  const std::string all =
      "verdict.succeed(truth.ball_x .. ' ' .. truth.ball_y .. ' ' .. truth.score .. ' ' .. "
      "truth.score_of_opponents)";
  EXPECT_EQ(record_of(all, ball).verdict.value().text, "2.5 -1.25 3.0 1.0");
  for (const std::string field : {"ball_x", "ball_y", "score", "score_of_opponents"})
    EXPECT_NE(fault_of_ball("verdict.succeed('' .. truth." + field + ")").find("truth." + field + " has no value"),
              std::string::npos)
        << "without a ball";
}

TEST(TeamScore, FollowsTheTeamWhenTheSidesChange) {
  TeamScore score;
  EXPECT_EQ(score.count({{1.0, 2.0}, 1, 0}, false).goals, 1);
  const BallTruth second_half = score.count({{1.0, 2.0}, 3, 1}, true);
  EXPECT_EQ(second_half.goals, 2) << "one at negative x";
  EXPECT_EQ(second_half.opponents_goals, 2);
  EXPECT_EQ(second_half.position, Eigen::Vector2d(-1.0, -2.0));
}

}  // namespace
}  // namespace reorient
