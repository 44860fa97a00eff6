// SPDX-License-Identifier: MIT
// Simulated games, short ones.
#include "program/game/soccer_game.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "program/program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

GameOptions small_game(double seconds = 3.0) {
  setenv("REORIENT_HOME", kSourceFolder, 1);
  GameOptions options;
  options.robots = 1;
  options.seconds = seconds;
  options.threads = 1;
  for (TeamOptions& team : options.teams) team.scripts = kProjectFolder / "scripts";
  options.parameters.assignments = {"match.initial_time=0.2", "match.ready_time=0.5", "match.set_time=0.5"};
  return options;
}

std::vector<GameEvent> events_of(SoccerGame& game) {
  std::vector<GameEvent> all;
  while (!game.is_over()) {
    for (GameEvent& event : game.step()) all.push_back(std::move(event));
  }
  return all;
}

std::string digest_of_game(const GameOptions& options) {
  SoccerGame game(options);
  events_of(game);
  return game.digest();
}

/// A root of scripts with one behavior, whose state runs these statements in each frame.
std::filesystem::path scripts_with(const TemporaryFolder& folder, const std::string& statements) {
  folder.write("behaviors/talk.lua",
               "behavior \"talk\" { priority = 10, initial = \"on\", state \"on\" { update = function() " + statements +
                   " end } }");
  return folder.path();
}

TEST(SoccerGame, IsTheSameForTheSameSeedAndAnyNumberOfThreads) {
  GameOptions options = small_game();
  options.robots = 2;
  const std::string once = digest_of_game(options);
  options.threads = 3;
  EXPECT_EQ(digest_of_game(options), once);
  options.seed = 2;
  EXPECT_NE(digest_of_game(options), once);
}

TEST(SoccerGame, StartsWithEachTeamInItsOwnHalf) {
  GameOptions options = small_game();
  options.robots = 5;
  SoccerGame game(options);
  game.step();
  for (std::size_t i = 0; i < game.robots(); ++i) {
    const GameRobot& robot = game.robot(i);
    EXPECT_LT(robot.record().world.pose.pose.position.x(), 0.0) << "in the axes of its team";
    EXPECT_TRUE(robot.has_correct_belief());
    const double x = robot.simulator().ground_truth().pose.position.x();
    EXPECT_LT(robot.team() == 0 ? x : -x, 0.0);
    EXPECT_EQ(robot.record().world.referee.state, GameState::initial);
  }
}

TEST(SoccerGame, SendsTheStateOfTheGameToEachRobot) {
  SoccerGame game(small_game());
  std::vector<GameState> states;
  while (!game.is_over()) {
    game.step();
    for (std::size_t i = 0; i < game.robots(); ++i) {
      const RefereeState& referee = game.robot(i).record().world.referee;
      EXPECT_EQ(referee.state, game.referee().state());
      EXPECT_EQ(referee.kick_off, game.robot(i).team() == 1 ? KickOff::ours : KickOff::theirs) << "of an odd seed";
    }
    if (states.empty() || states.back() != game.referee().state()) states.push_back(game.referee().state());
  }
  EXPECT_EQ(states, (std::vector<GameState>{GameState::initial, GameState::ready, GameState::set, GameState::playing,
                                            GameState::finished}));
  EXPECT_NEAR(game.time(), 3.0, 0.05);
}

TEST(SoccerGame, ShowsTheBallToTheRobots) {
  SoccerGame game(small_game());
  events_of(game);
  for (std::size_t i = 0; i < game.robots(); ++i) {
    const ApplicationRecord& application = game.robot(i).record().application;
    for (std::size_t value = 0; value < application.values.size(); ++value) {
      const std::string& name = application.declared->values[value].name;
      EXPECT_EQ(application.values[value].set_at >= 0.0, name.starts_with("ball.")) << name;
    }
  }
}

TEST(SoccerGame, IsPlayedByTheShippedBehaviors) {
  GameOptions options = small_game(30.0);
  options.parameters.assignments.emplace_back("collisions.fall_rate=0");
  SoccerGame game(options);
  events_of(game);
  EXPECT_GT(game.result(0).kicks + game.result(1).kicks, 0);
  EXPECT_EQ(game.result(0).faults + game.result(1).faults, 0);
  EXPECT_EQ(game.result(0).falls + game.result(1).falls, 0);
}

TEST(SoccerGame, DeliversMessagesToTeammatesOnly) {
  const TemporaryFolder folder;
  GameOptions options = small_game(1.0);
  options.robots = 2;
  options.teams[0].scripts = scripts_with(folder, "team.send('hello')");
  options.teams[0].behaviors = {"talk"};
  options.teams[1].behaviors = {"get_up"};
  options.parameters.assignments.emplace_back("network.loss=0");
  SoccerGame game(options);
  std::vector<std::size_t> heard(game.robots());
  while (!game.is_over()) {
    game.step();
    for (std::size_t i = 0; i < game.robots(); ++i) {
      for (const Message& message : game.robot(i).record().inputs.messages) {
        EXPECT_EQ(message.text, "hello");
        EXPECT_EQ(message.sender, 3 - game.robot(i).number());
        ++heard[i];
      }
    }
  }
  EXPECT_GT(heard[0], 20u);
  EXPECT_GT(heard[1], 20u);
  EXPECT_EQ(heard[2] + heard[3], 0u);
}

TEST(SoccerGame, ReportsErrorsOfScriptsAndContinues) {
  const TemporaryFolder folder;
  GameOptions options = small_game(1.0);
  options.teams[1].scripts = scripts_with(folder, "local a = nil + 1");
  options.teams[1].behaviors = {"talk"};
  SoccerGame game(options);
  const std::vector<GameEvent> events = events_of(game);
  EXPECT_GT(game.result(1).faults, 0);
  EXPECT_EQ(game.result(0).faults, 0);
  EXPECT_NE(events.at(0).text.find("red 1 has an error in behaviors/talk.lua"), std::string::npos) << events[0].text;
}

TEST(GameCommand, PrintsTheTimelineTheScoreAndTheDigest) {
  const std::vector<std::string> words{"game",  "--robots", "1", "--seconds", "3", "--set", "match.initial_time=0.5",
                                       "--log", "off"};
  const ProgramRun run = run_reorient(words);
  EXPECT_EQ(run.code, kSuccess) << run.err;
  EXPECT_NE(run.out.find(" s  ready\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("blue 0, red 0\n"), std::string::npos);
  EXPECT_EQ(digest_of(run), digest_of(run_reorient(words)));
}

TEST(GameCommand, RefusesBadOptionsWithOneLine) {
  const std::vector<std::vector<std::string>> bad{{"--robots", "0"},
                                                  {"--robots", "6"},
                                                  {"--robots", "two"},
                                                  {"--threads", "0"},
                                                  {"--seconds", "-1"},
                                                  {"--seconds", "nan"},
                                                  {"--seed", "-3"},
                                                  {"--width", "100"},
                                                  {"--room", "no-such-room"},
                                                  {"--body", "no-such-body"},
                                                  {"--scripts", "/no/such/folder"},
                                                  {"--scripts-of-opponents", "/no/such/folder"},
                                                  {"--behaviors", "search_bal"},
                                                  {"--behaviors-of-opponents", "search_bal"},
                                                  {"--set", "network.loss=2"},
                                                  {"--set", "match.set_time=x"}};
  for (const std::vector<std::string>& words : bad) {
    std::vector<std::string> line{"game", "--seconds", "1"};
    if (words[0] == "--seconds") line.resize(1);
    line.insert(line.end(), words.begin(), words.end());
    const ProgramRun run = run_reorient(line);
    EXPECT_EQ(run.code, kBadInput) << words[0] << " " << words[1];
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

}  // namespace
}  // namespace reorient
