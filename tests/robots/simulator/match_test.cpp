// SPDX-License-Identifier: MIT
// The referee and the network of a simulated game.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "robots/simulator/game/match_referee.h"
#include "robots/simulator/game/team_network.h"

namespace reorient {
namespace {

constexpr double kMatchStep = 0.1;  // s

RollingBall ball_lying_at(double x, double y) {
  RollingBall ball;
  ball.position = {x, y};
  return ball;
}

/// The events of `seconds` with this ball.
std::vector<MatchReferee::Decision> events_of(MatchReferee& referee, double seconds, const RollingBall& ball = {}) {
  std::vector<MatchReferee::Decision> events;
  for (int i = 0; i < std::lround(seconds / kMatchStep); ++i) {
    const MatchReferee::Decision decision = referee.advance(kMatchStep, ball, std::nullopt);
    if (decision.event) events.push_back(decision);
  }
  return events;
}

MatchReferee playing_referee(int first_kick_off = 0, double duration = 600.0) {
  MatchReferee referee({}, FieldDimensions{}, duration, first_kick_off);
  events_of(referee, 10.3);
  EXPECT_EQ(referee.state(), GameState::playing);
  return referee;
}

TEST(MatchReferee, FollowsTheStatesOfAGame) {
  MatchReferee referee({}, FieldDimensions{}, 20.0, 1);
  EXPECT_EQ(referee.state_for(0), (RefereeState{false, GameState::initial, false, KickOff::theirs}));
  EXPECT_EQ(referee.state_for(1).kick_off, KickOff::ours);
  const std::vector<MatchReferee::Decision> events = events_of(referee, 30.0);
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].event, MatchEvent::ready);
  EXPECT_EQ(events[1].event, MatchEvent::set);
  EXPECT_EQ(events[1].ball, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(events[2].event, MatchEvent::playing);
  EXPECT_EQ(events[2].team, 1);
  EXPECT_EQ(events[3].event, MatchEvent::finished);
  EXPECT_EQ(referee.state(), GameState::finished);
}

TEST(MatchReferee, CountsAGoalOnceAndGivesTheKickOffToTheOtherTeam) {
  MatchReferee referee = playing_referee();
  const std::vector<MatchReferee::Decision> events = events_of(referee, 1.0, ball_lying_at(4.7, 0.2));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].event, MatchEvent::goal);
  EXPECT_EQ(events[0].team, 0);
  EXPECT_EQ(referee.score(), (std::array<int, 2>{1, 0}));
  EXPECT_EQ(referee.state(), GameState::ready);
  EXPECT_EQ(referee.state_for(1).kick_off, KickOff::ours);
}

TEST(MatchReferee, CountsNoGoalUnlessTheGameRuns) {
  MatchReferee referee({}, FieldDimensions{}, 600.0, 0);
  events_of(referee, 1.0, ball_lying_at(4.7, 0.2));
  EXPECT_EQ(referee.score(), (std::array<int, 2>{0, 0}));
}

TEST(MatchReferee, PutsABallBackThatIsOut) {
  const auto decision_of = [](double x, double y, int touched_by) {
    MatchReferee referee = playing_referee();
    return referee.advance(kMatchStep, ball_lying_at(x, y), touched_by);
  };
  const auto at_touchline = decision_of(1.5, -3.2, 0);
  EXPECT_EQ(at_touchline.event, MatchEvent::touchline);
  EXPECT_EQ(at_touchline.ball, Eigen::Vector2d(1.5, -3.0));
  EXPECT_EQ(at_touchline.team, 1);
  const auto goal_kick = decision_of(4.7, 1.5, 0);
  EXPECT_EQ(goal_kick.event, MatchEvent::goal_kick);
  EXPECT_EQ(goal_kick.ball, Eigen::Vector2d(3.9, 1.1));
  EXPECT_EQ(goal_kick.team, 1);
  const auto corner_kick = decision_of(4.7, -1.5, 1);
  EXPECT_EQ(corner_kick.event, MatchEvent::corner_kick);
  EXPECT_EQ(corner_kick.ball, Eigen::Vector2d(4.5, -3.0));
  EXPECT_EQ(corner_kick.team, 0);
}

TEST(MatchReferee, PutsABallOnTheCenterMarkThatNoRobotTouches) {
  MatchReferee referee = playing_referee();
  const std::vector<MatchReferee::Decision> events = events_of(referee, 29.0, ball_lying_at(2.0, 2.0));
  EXPECT_TRUE(events.empty());
  referee.advance(kMatchStep, ball_lying_at(2.0, 2.0), 1);
  EXPECT_TRUE(events_of(referee, 29.0, ball_lying_at(2.0, 2.0)).empty()) << "a robot touched it";
  const std::vector<MatchReferee::Decision> later = events_of(referee, 2.0, ball_lying_at(2.0, 2.0));
  ASSERT_EQ(later.size(), 1u);
  EXPECT_EQ(later[0].event, MatchEvent::stuck);
  EXPECT_EQ(later[0].ball, Eigen::Vector2d(0.0, 0.0));
}

TEST(TeamNetwork, DeliversEachMessageToItsReceiverAfterTheDelay) {
  NetworkParameters parameters{0.0, 0.2, 0.0};
  TeamNetwork network(parameters, 1);
  network.send(1.0, 2, {4, "hello"});
  EXPECT_TRUE(network.take(1.1, 2).empty());
  EXPECT_TRUE(network.take(2.0, 1).empty());
  const std::vector<Message> arrived = network.take(1.21, 2);
  ASSERT_EQ(arrived.size(), 1u);
  EXPECT_EQ(arrived[0].sender, 4);
  EXPECT_EQ(arrived[0].text, "hello");
  EXPECT_TRUE(network.take(9.0, 2).empty()) << "once";
}

TEST(TeamNetwork, LosesTheStatedFraction) {
  TeamNetwork network({0.25, 0.0, 0.1}, 1);
  for (int i = 0; i < 4000; ++i) network.send(0.01 * i, 0, {1, "text"});
  EXPECT_EQ(network.sent(), 4000u);
  EXPECT_NEAR(static_cast<double>(network.lost()), 1000.0, 90.0);
  EXPECT_EQ(network.take(1000.0, 0).size(), network.sent() - network.lost());
}

TEST(TeamNetwork, DeliversMessagesInTheOrderOfTheirArrival) {
  TeamNetwork network({0.0, 0.0, 1.0}, 3);
  for (int i = 0; i < 20; ++i) network.send(0.0, 0, {i, ""});
  std::vector<int> order;
  for (double time = 0.0; time <= 1.01; time += 0.02) {
    for (const Message& message : network.take(time, 0)) order.push_back(message.sender);
  }
  ASSERT_EQ(order.size(), 20u);
  EXPECT_FALSE(std::is_sorted(order.begin(), order.end()));
}

}  // namespace
}  // namespace reorient
