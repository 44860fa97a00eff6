// SPDX-License-Identifier: MIT
// `reorient game`: a simulated game of two teams.
#include <chrono>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "geometry/image.h"
#include "program/game/game_recording.h"
#include "program/game/soccer_game.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/options.h"
#include "program/program.h"
#include "program/subcommand.h"

namespace reorient {
namespace {

constexpr const char* kGameGroup = "Game";

void print_team(const SoccerGame& game, int team, std::ostream& out) {
  const TeamResult result = game.result(team);
  out << fmt::format("  {}: {}, {}, {}, {}, {}, {}, {} of {} beliefs right at the end\n", team_name(team),
                     counted(result.goals, "goal"), counted(result.kicks, "kick"),
                     counted(result.failed_kicks, "failed kick"), counted(result.falls, "fall"),
                     counted(result.faults, "script error"), counted(result.flips, "flip"), result.correct_beliefs,
                     game.robots() / 2);
}

void print_summary_of_game(const SoccerGame& game, double wall_seconds, int threads, std::ostream& out) {
  const auto& score = game.referee().score();
  const double frames = game.time() / game.robot(0).simulator().time_step() * static_cast<double>(game.robots());
  out << fmt::format("\n{} {}, {} {}\n", team_name(0), score[0], team_name(1), score[1]);
  for (const int team : {0, 1}) print_team(game, team, out);
  out << fmt::format("  {}, {} lost\n", counted(game.network().sent(), "team message"), game.network().lost());
  out << fmt::format("  {:.1f} s of {} with {}, {:.0f} frames per second ({:.1f} times real time)\n", game.time(),
                     counted(game.robots(), "robot"), counted(threads, "thread"), frames / wall_seconds,
                     game.time() / wall_seconds);
  out << "digest: " << game.digest() << '\n';
}

int play_game(GameOptions options, std::ostream& out, std::ostream& err) {
  options.teams[0].scripts = scripts_root(options.teams[0].scripts);
  options.teams[1].scripts =
      options.teams[1].scripts.empty() ? options.teams[0].scripts : scripts_root(options.teams[1].scripts);
  SoccerGame game(options);
  const Interruption interruption;
  GameRecording recording(options, game);
  const auto start = std::chrono::steady_clock::now();
  while (!game.is_over() && Interruption::signal() == 0) {
    for (const GameEvent& event : game.step()) out << fmt::format("{:6.2f} s  {}\n", event.time, event.text);
    out.flush();
    recording.keep_up(err);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  recording.end(out, err);
  print_summary_of_game(game, took.count(), options.threads, out);
  return Interruption::signal() != 0 ? exit_code_of(Interruption::signal()) : kSuccess;
}

void add_recording_options(CLI::App& game, RecordOptions& options) {
  game.add_option("--record", options.record, "record each robot into this folder (blue_1.mcap, ...)")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  add_record_options(game, options);
}

void add_team_options(CLI::App& game, GameOptions& options) {
  add_scripts_option(game, options.teams[0].scripts);
  game.add_option("--scripts-of-opponents", options.teams[1].scripts,
                  "scripts of the red team (default: those of the blue team)")
      ->type_name("FOLDER")
      ->group(kParameterGroup)
      ->check(check_not_empty);
  game.add_option("--behaviors", options.teams[0].behaviors, "behaviors of the blue team (default: those for soccer)")
      ->type_name("A,B,...")
      ->group(kGameGroup)
      ->delimiter(',')
      ->check(check_not_empty);
  game.add_option("--behaviors-of-opponents", options.teams[1].behaviors,
                  "behaviors of the red team (default: those for soccer)")
      ->type_name("A,B,...")
      ->group(kGameGroup)
      ->delimiter(',')
      ->check(check_not_empty);
}

}  // namespace

Subcommand add_game(CLI::App& program) {
  const auto options = std::make_shared<GameOptions>();
  CLI::App* const parser = program.add_subcommand("game", "play a simulated game of two teams");
  parser->fallthrough();
  set_examples(*parser, {{"reorient game", "five against five, 300 s"},
                         {"reorient game --robots 1 --seconds 60", "one against one"},
                         {"reorient game --scripts mine --scripts-of-opponents scripts", "two teams of scripts"},
                         {"reorient game --record game", "record each robot, for replays"}});
  parser->add_option("--robots", options->robots, "robots in each team")
      ->type_name("N")
      ->group(kGameGroup)
      ->check(CLI::Range(1, 5))
      ->capture_default_str();
  parser->add_option("--seconds", options->seconds, "duration of the game in simulated seconds")
      ->type_name("SECONDS")
      ->group(kGameGroup)
      ->check(check_seconds)
      ->capture_default_str();
  parser->add_option("--seed", options->seed, "seed of all random numbers")
      ->type_name("N")
      ->group(kGameGroup)
      ->check(check_seed)
      ->capture_default_str();
  parser->add_option("--threads", options->threads, "threads that run the robots; the result is the same")
      ->type_name("N")
      ->group(kGameGroup)
      ->check(CLI::Range(1, 10))
      ->capture_default_str();
  parser->add_flag("!--no-room-awareness", options->room_awareness, "switch room awareness off")->group(kGameGroup);
  add_body_options(*parser, options->body, options->field);
  CLI::Option* const room =
      parser->add_option("--room", options->room, "panorama: .hdr, .png or .jpg (default: a hall)")
          ->type_name("FILE")
          ->group(kRobotGroup)
          ->check(check_not_empty);
  parser->add_option("--hall-seed", options->hall_seed, "seed of the built-in hall")
      ->type_name("N")
      ->group(kRobotGroup)
      ->check(check_seed)
      ->capture_default_str()
      ->excludes(room);
  parser->add_option("--width", options->width, "width of the camera image in pixels")
      ->type_name("N")
      ->group(kRobotGroup)
      ->check(CLI::IsMember(kImageWidths))
      ->capture_default_str();
  add_team_options(*parser, *options);
  add_parameter_options(*parser, options->parameters);
  add_recording_options(*parser, options->recording);
  return {parser, [options](std::ostream& out, std::ostream& err) { return play_game(*options, out, err); }};
}

}  // namespace reorient
