// SPDX-License-Identifier: MIT
// The simulator as the application of an interface with a ball.
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulator/simulator.h"
#include "tests/declared_field.h"
#include "tests/robots/simulator/shared_hall.h"

namespace reorient {
namespace {

ApplicationInterface ball_interface() {
  ApplicationInterface declared;
  declared.name = "ball";
  declared.values.push_back({"mood", "", {declared_field("", FieldType::text, {{}, {""}})}});
  declared.values.push_back({"ball.seen", "", {declared_field("", FieldType::boolean, {{0.0}, {}})}});
  declared.values.push_back({"ball.position", "", {declared_field("", FieldType::point, {{0.0, 0.0}, {}})}});
  declared.values.push_back({"ball.distance", "", {declared_field("", FieldType::number, {{20.0}, {}})}});
  declared.actions.push_back({"say", "", {declared_field("text", FieldType::text, {{}, {""}})}, 1.0, false});
  declared.actions.push_back({"kick",
                              "",
                              {declared_field("strength", FieldType::number, {{1.0}, {}}),
                               declared_field("foot", FieldType::text, {{}, {"left"}}),
                               declared_field("direction", FieldType::number, {{0.0}, {}})},
                              4.0,
                              true});
  return declared;
}

SimulatorParameters exact_sensor() {
  SimulatorParameters parameters;
  parameters.width = 160;
  parameters.other_robots = 0;
  parameters.ball_sensor.missed = 0.0;
  return parameters;
}

Simulator simulator_at(const Pose2& pose, const SimulatorParameters& parameters = exact_sensor()) {
  Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), pose, 1);
  simulator.play_application(ball_interface());
  return simulator;
}

/// The last value with this index.
std::optional<FieldData> value_of(const Observation& observation, std::uint16_t value) {
  std::optional<FieldData> found;
  for (const SetValue& set : observation.external.values) {
    if (set.value == value) found = set.data;
  }
  return found;
}

Answer kick_with(const std::string& foot, double direction, std::uint32_t id = 1) {
  Answer answer;
  answer.actions.push_back({id, 1, {{1.0, direction}, {foot}}});
  return answer;
}

std::vector<ActionReport> reports_of(Simulator& simulator, const Answer& answer, int frames) {
  Observation observation;
  std::vector<ActionReport> reports;
  simulator.answer(answer);
  for (int i = 0; i < frames; ++i) {
    simulator.observe(observation);
    reports.insert(reports.end(), observation.external.reports.begin(), observation.external.reports.end());
    simulator.answer({});
  }
  return reports;
}

TEST(SimulatedBall, IsReportedRelativeToTheRobot) {
  Simulator simulator = simulator_at(Pose2(1.0, 1.0, kPi / 2.0));
  simulator.put_ball({0.8, 2.5});
  Observation observation;
  simulator.observe(observation);
  EXPECT_EQ(value_of(observation, 1).value().numbers, std::vector<double>{1.0});
  const FieldData position = value_of(observation, 2).value();
  EXPECT_NEAR(position.numbers.at(0), 1.5, 0.2);
  EXPECT_NEAR(position.numbers.at(1), 0.2, 0.1);
  EXPECT_NEAR(value_of(observation, 3).value().numbers.at(0), 1.51, 0.2);
  EXPECT_FALSE(value_of(observation, 0)) << "a value that is not of the ball";
}

TEST(SimulatedBall, BehindTheRobotIsNotSeen) {
  Simulator simulator = simulator_at(Pose2(1.0, 1.0, kPi / 2.0));
  simulator.put_ball({1.0, -1.0});
  Observation observation;
  simulator.observe(observation);
  EXPECT_EQ(value_of(observation, 1).value().numbers, std::vector<double>{0.0});
  EXPECT_FALSE(value_of(observation, 2));
}

TEST(SimulatedBall, IsNotReportedWithoutAnInterfaceOrWithOtherTypes) {
  Simulator without(exact_sensor(), RobotBody(), FieldDimensions{}, shared_hall(), Pose2(0.0, 0.0, 0.0), 1);
  Observation observation;
  without.observe(observation);
  EXPECT_TRUE(observation.external.values.empty());

  ApplicationInterface other = ball_interface();
  other.values[1].fields[0].type = FieldType::number;
  other.values[2].most = 3;
  other.values[3].name = "ball.far";
  without.play_application(other);
  without.put_ball({1.5, 0.0});
  without.observe(observation);
  EXPECT_TRUE(observation.external.values.empty());
}

TEST(SimulatedBall, IsKickedAndTheKickIsReported) {
  Simulator simulator = simulator_at(Pose2(0.0, 0.0, 0.0));
  simulator.put_ball({0.24, 0.06});
  const std::vector<ActionReport> reports = reports_of(simulator, kick_with("left", 0.3, 9), 90);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].state, ActionState::running);
  EXPECT_EQ(reports[1].state, ActionState::done) << reports[1].reason;
  EXPECT_EQ(reports[1].id, 9u);
  const Eigen::Vector2d path = simulator.ball().position - Eigen::Vector2d(0.24, 0.06);
  EXPECT_GT(path.norm(), 1.0);
  EXPECT_NEAR(std::atan2(path.y(), path.x()), 0.3, 0.3);
}

TEST(SimulatedBall, OutOfReachLetsTheKickFail) {
  Simulator simulator = simulator_at(Pose2(0.0, 0.0, 0.0));
  simulator.put_ball({0.6, 0.06});
  const std::vector<ActionReport> reports = reports_of(simulator, kick_with("left", 0.0), 90);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[1].state, ActionState::failed);
  EXPECT_EQ(reports[1].reason.substr(0, 40), "the ball is out of reach: 0.60 m ahead a");
  EXPECT_EQ(simulator.ball().position, Eigen::Vector2d(0.6, 0.06));
}

TEST(SimulatedBall, IsNotKickedByARobotThatIsPenalizedLiftedOrFallen) {
  const auto penalize = [](Simulator& simulator) { simulator.penalize(true); };
  const auto lift = [](Simulator& simulator) { simulator.pick_up(); };
  const auto fell = [](Simulator& simulator) { simulator.push_over(); };
  const std::vector<std::pair<std::function<void(Simulator&)>, const char*>> hindrances{
      {penalize, "the robot is penalized"}, {lift, "the robot is lifted"}, {fell, "the robot does not stand"}};
  for (const int frames_before : {0, 10}) {  // before the kick, and while the leg swings
    for (const auto& [hinder, reason] : hindrances) {
      Simulator simulator = simulator_at(Pose2(0.0, 0.0, 0.0));
      simulator.put_ball({0.24, 0.06});
      std::vector<ActionReport> reports = reports_of(simulator, kick_with("left", 0.0, 5), frames_before);
      hinder(simulator);
      const std::vector<ActionReport> later = reports_of(simulator, {}, 60);
      reports.insert(reports.end(), later.begin(), later.end());
      ASSERT_FALSE(reports.empty()) << reason;
      EXPECT_EQ(reports.back().state, ActionState::failed) << reason;
      EXPECT_EQ(reports.back().reason, reason);
      EXPECT_EQ(reports.back().id, 5u);
      EXPECT_EQ(simulator.ball().velocity, Eigen::Vector2d(0.0, 0.0)) << reason;
    }
  }
}

TEST(SimulatedBall, IsKickedAgainAfterThePenalty) {
  Simulator simulator = simulator_at(Pose2(0.0, 0.0, 0.0));
  simulator.put_ball({0.24, 0.06});
  simulator.penalize(true);
  reports_of(simulator, kick_with("left", 0.0, 1), 30);
  simulator.penalize(false);
  const std::vector<ActionReport> reports = reports_of(simulator, kick_with("left", 0.0, 2), 90);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports.back().state, ActionState::done) << reports.back().reason;
}

TEST(SimulatedBall, IsKickedFromAWalkAfterTheRobotHasStopped) {
  Simulator simulator = simulator_at(Pose2(-0.3, 0.0, 0.0));
  simulator.put_ball({0.5, 0.05});
  Observation observation;
  Answer walk;
  walk.request.walk = {0.2, 0.0, 0.0};
  for (int i = 0; i < 60; ++i) {
    simulator.answer(walk);
    simulator.observe(observation);
  }
  Answer answer = kick_with("left", 0.0);
  answer.request.walk = {0.2, 0.0, 0.0};
  simulator.answer(answer);
  for (int i = 0; i < 20; ++i) simulator.observe(observation);
  EXPECT_EQ(simulator.robot().velocity().forward, 0.0) << "the robot stands for the kick although a walk is requested";
}

TEST(SimulatedBall, InAGoalCountsOnce) {
  Simulator simulator = simulator_at(Pose2(0.0, 0.0, 0.0));
  Observation observation;
  const auto observe_with_ball_at = [&](double x, double y) {
    simulator.put_ball({x, y});
    for (int i = 0; i < 3; ++i) simulator.observe(observation);
  };
  observe_with_ball_at(4.7, 0.1);
  EXPECT_EQ(simulator.true_ball()->goals, 1);
  observe_with_ball_at(1.0, 0.1);
  observe_with_ball_at(4.7, 1.5);
  EXPECT_EQ(simulator.true_ball()->goals, 1) << "beside the goal";
  observe_with_ball_at(-4.7, 0.1);
  EXPECT_EQ(simulator.true_ball()->goals, 1);
  EXPECT_EQ(simulator.true_ball()->opponents_goals, 1);
}

TEST(SimulatedBall, DoesNotChangeWhatTheRobotSeesOtherwise) {
  SimulatorParameters parameters = exact_sensor();
  Simulator with = simulator_at(Pose2(0.0, 0.0, 0.0), parameters);
  Simulator without(parameters, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(0.0, 0.0, 0.0), 1);
  Observation a, b;
  for (int i = 0; i < 20; ++i) {
    with.observe(a);
    without.observe(b);
    ASSERT_EQ(a.odometry.position, b.odometry.position);
    for (int row = 0; row < a.upper->image.height; ++row)
      ASSERT_TRUE(std::equal(a.upper->image.row(row), a.upper->image.row(row) + 2 * a.upper->image.width,
                             b.upper->image.row(row)));
  }
}

TEST(SharedWorld, ReplacesTheOtherRobotsAndTheBall) {
  Simulator simulator = simulator_at(Pose2(0.0, 0.0, 0.0));
  SharedWorld world;
  Player other;
  other.pose = Pose2(1.5, 0.0, 0.0);
  world.others.push_back(other);
  world.ball.position = {2.0, 0.0};
  Observation observation;
  simulator.share(world);
  for (int i = 0; i < 5; ++i) {
    simulator.advance();
    simulator.share(world);
    simulator.observe(observation);
    EXPECT_EQ(value_of(observation, 1).value().numbers, std::vector<double>{0.0}) << "the other robot hides the ball";
    EXPECT_NEAR(observation.time, i / 30.0, 1e-9);
  }
  EXPECT_EQ(simulator.ball().position, world.ball.position) << "only the game moves the ball";
}

}  // namespace
}  // namespace reorient
