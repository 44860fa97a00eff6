// SPDX-License-Identifier: MIT
// A simulated game: two teams of robots, each with its own engine, in one world with one ball. The same options give
// the same game, for any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program/game/game_options.h"
#include "program/game/game_robot.h"
#include "program/game/worker_team.h"
#include "program/robots.h"
#include "robots/simulator/game/match_referee.h"
#include "robots/simulator/game/team_network.h"

namespace reorient {

/// "blue" and "red", the colors of their jerseys.
const char* team_name(int team);

/// A line of the timeline.
struct GameEvent {
  double time = 0.0;  ///< s
  std::string text;
};

struct TeamResult {
  int goals = 0;
  int kicks = 0;         ///< that hit the ball
  int failed_kicks = 0;  ///< that the simulator reported as failed
  int falls = 0;
  int faults = 0;           ///< errors of scripts
  int correct_beliefs = 0;  ///< robots whose believed pose is right at the end
  std::uint64_t flips = 0;
};

class SoccerGame {
 public:
  /// Throws std::runtime_error (of scripts: ScriptError) with one line.
  explicit SoccerGame(const GameOptions& options);

  /// Plays one frame of all robots and returns what happened. Call it until is_over().
  std::vector<GameEvent> step();
  bool is_over() const { return referee_.state() == GameState::finished; }

  double time() const { return time_; }  ///< s
  std::size_t robots() const { return robots_.size(); }
  const GameRobot& robot(std::size_t index) const { return *robots_[index]; }
  /// Shows the frames of a robot to the observer, on any thread. Call it before the first step().
  void show_to(Observer& observer, std::size_t robot) { robots_[robot]->show_to(observer); }
  const RollingBall& ball() const { return ball_; }
  const MatchReferee& referee() const { return referee_; }
  const TeamNetwork& network() const { return network_; }
  TeamResult result(int team) const;
  /// Of all frames of all robots.
  std::string digest() const;

 private:
  SoccerGame(const GameOptions& options, RobotOptions robot);
  void add_robot(const GameOptions& options, const RobotOptions& robot, const ScriptTexts& scripts, int team,
                 int number);
  void move_robots();
  void move_ball();
  void let_robots_fall();
  void judge();
  void place_robots();
  void play_frame();
  void listen();
  void note(std::string text);

  FieldDimensions field_;
  GameRules rules_;
  RoomCache rooms_;
  std::vector<std::unique_ptr<GameRobot>> robots_;  // team 0, then team 1
  RollingBall ball_;
  MatchReferee referee_;
  TeamNetwork network_;
  Random chance_;  // of falls
  WorkerTeam workers_;
  std::optional<int> touched_by_;  // team, in this frame
  std::array<TeamResult, 2> results_{};
  std::vector<GameEvent> events_;
  double time_ = 0.0;  // s
  std::uint64_t frame_ = 0;
};

}  // namespace reorient
