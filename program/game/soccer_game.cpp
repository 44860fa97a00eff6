// SPDX-License-Identifier: MIT
#include "program/game/soccer_game.h"

#include <algorithm>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "engine/record/digest.h"
#include "program/run/engine_setup.h"
#include "program/run/venue.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

constexpr std::uint64_t kFallStream = 0xfa11;

/// What robots run that play soccer.
std::vector<std::string> soccer_behaviors() {
  return {"orientation", "background_training", "kidnap_recovery", "get_up",
          "search_ball", "approach_ball",       "kick_ball"};
}

/// Kick-off poses in the axes of the team, in its own half: an attacker outside of the center circle, then pairs that
/// stand farther back, then the keeper.
Pose2 kick_off_pose(const FieldDimensions& field, int number) {
  const Eigen::Vector2d half = field_half_size(field);
  const double before_circle = -field.center_circle_radius - 0.25;
  switch (number) {
    case 1:
      return {before_circle, 0.0, 0.0};
    case 2:
      return {-0.3 * half.x(), 0.45 * half.y(), 0.0};
    case 3:
      return {-0.3 * half.x(), -0.45 * half.y(), 0.0};
    case 4:
      return {-0.65 * half.x(), 0.2 * half.y(), 0.0};
    default:
      return {-half.x() + 0.3, 0.0, 0.0};
  }
}

RobotOptions robot_options(const GameOptions& options) {
  RobotOptions robot;
  robot.body = load_body(body_file(options.body));
  robot.field = load_field(field_file(options.field, robot.body));
  robot.room = options.room.empty() ? "" : room_file(options.room);
  robot.hall_seed = options.hall_seed;
  robot.width = options.width;
  robot.parameters = overrides_of(options.parameters);
  robot.application = interface_named(options.interface);
  return robot;
}

std::uint64_t seed_of(const GameOptions& options, int team, int number) {
  return scatter(options.seed ^ scatter(static_cast<std::uint64_t>(100 * (team + 1) + number)));
}

std::string text_of(const MatchReferee::Decision& decision, const std::array<int, 2>& score) {
  const char* const team = team_name(decision.team);
  switch (*decision.event) {
    case MatchEvent::ready:
      return "ready";
    case MatchEvent::set:
      return fmt::format("set: kick-off for {}", team);
    case MatchEvent::playing:
      return fmt::format("playing: kick-off for {}", team);
    case MatchEvent::finished:
      return "finished";
    case MatchEvent::goal:
      return fmt::format("goal for {} ({}:{})", team, score[0], score[1]);
    case MatchEvent::touchline:
      return fmt::format("the ball is out: kick-in for {}", team);
    case MatchEvent::goal_kick:
      return fmt::format("the ball is out: goal kick for {}", team);
    case MatchEvent::corner_kick:
      return fmt::format("the ball is out: corner kick for {}", team);
    case MatchEvent::stuck:
      return "the ball was not touched: put on the center mark";
  }
  return "";
}

}  // namespace

const char* team_name(int team) { return team == 0 ? "blue" : "red"; }

SoccerGame::SoccerGame(const GameOptions& options) : SoccerGame(options, robot_options(options)) {}

SoccerGame::SoccerGame(const GameOptions& options, RobotOptions robot)
    : field_(robot.field),
      rules_(game_rules(robot)),
      referee_(rules_.match, field_, options.seconds, static_cast<int>(options.seed % 2)),
      network_(rules_.network, options.seed),
      chance_(options.seed, kFallStream),
      workers_(options.threads) {
  robot.rooms = &rooms_;
  ball_.radius = 0.5 * field_.ball_diameter;
  for (const int team : {0, 1}) {
    const ScriptTexts scripts = read_scripts(options.teams[static_cast<std::size_t>(team)].scripts);
    for (int number = 1; number <= options.robots; ++number) add_robot(options, robot, scripts, team, number);
  }
  place_robots();
}

void SoccerGame::add_robot(const GameOptions& options, const RobotOptions& robot, const ScriptTexts& scripts, int team,
                           int number) {
  const TeamOptions& of_team = options.teams[static_cast<std::size_t>(team)];
  RobotOptions own = robot;
  own.seed = seed_of(options, team, number);
  EngineOptions engine;
  engine.scripts = of_team.scripts;
  engine.interface = options.interface;
  engine.behaviors = of_team.behaviors.empty() ? soccer_behaviors() : of_team.behaviors;
  engine.parameters = options.parameters;
  engine.seed = own.seed;
  engine.room_awareness = options.room_awareness;
  std::unique_ptr<Simulator> simulator = make_player(own, options.seed);
  FrameSetup setup = engine_setup(engine, scripts, simulator->body(), field_, {});
  robots_.push_back(std::make_unique<GameRobot>(team, number, std::move(simulator), std::move(setup)));
}

std::vector<GameEvent> SoccerGame::step() {
  events_.clear();
  // In the first frame the robots stand where they were placed.
  if (frame_ == 0) {
    for (const auto& robot : robots_) robot->inputs().referee = referee_.state_for(robot->team());
  }
  move_robots();
  move_ball();
  let_robots_fall();
  judge();
  play_frame();
  listen();
  ++frame_;
  time_ = static_cast<double>(frame_) * robots_.front()->simulator().time_step();
  return std::move(events_);
}

void SoccerGame::move_robots() {
  for (const auto& robot : robots_) robot->simulator().advance();
}

void SoccerGame::move_ball() {
  const Simulator& any = robots_.front()->simulator();
  touched_by_.reset();
  for (const auto& robot : robots_) {
    const Simulator& simulator = robot->simulator();
    TeamResult& result = results_[static_cast<std::size_t>(robot->team())];
    if (simulator.kicked()) {
      ball_.velocity = *simulator.kicked();
      touched_by_ = robot->team();
      ++result.kicks;
    }
    if (simulator.robot().posture() == Body::Posture::carried) continue;
    if (ball_.touch(simulator.robot().pose().position, Body::kRadius, rules_.ball)) touched_by_ = robot->team();
  }
  ball_.advance(any.time_step(), rules_.ball, any.fixed_barriers(), carpet_half_size(field_));
}

void SoccerGame::let_robots_fall() {
  std::vector<MovingRobot> moving;
  moving.reserve(robots_.size());
  for (const auto& robot : robots_) moving.push_back(robot->moving());
  const double contact = Body::kRadius + Players::kRadius + 0.02;
  for (const std::size_t index :
       falls(moving, contact, rules_.collisions, robots_.front()->simulator().time_step(), chance_)) {
    GameRobot& robot = *robots_[index];
    robot.simulator().push_over();
    ++results_[static_cast<std::size_t>(robot.team())].falls;
    note(fmt::format("{} {} falls", team_name(robot.team()), robot.number()));
  }
}

void SoccerGame::judge() {
  const GameState before = referee_.state();
  const MatchReferee::Decision decision =
      referee_.advance(robots_.front()->simulator().time_step(), ball_, touched_by_);
  if (!decision.event) return;
  note(text_of(decision, referee_.score()));
  if (decision.ball) {
    ball_.position = *decision.ball;
    ball_.velocity.setZero();
  }
  if (referee_.state() == before) return;
  if (referee_.state() == GameState::set) place_robots();
  for (const auto& robot : robots_) robot->inputs().referee = referee_.state_for(robot->team());
}

void SoccerGame::place_robots() {
  for (const auto& robot : robots_) robot->place(in_axes_of(robot->team(), kick_off_pose(field_, robot->number())));
}

void SoccerGame::play_frame() {
  std::vector<Player> players;
  players.reserve(robots_.size());
  for (const auto& robot : robots_) players.push_back(robot->player());
  for (std::size_t i = 0; i < robots_.size(); ++i) robots_[i]->inputs().messages = network_.take(time_, i);
  workers_.run(robots_.size(), [&](std::size_t index) {
    SharedWorld world{players, ball_};
    world.others.erase(world.others.begin() + static_cast<std::ptrdiff_t>(index));
    robots_[index]->play(world);
  });
}

/// Collects messages, errors and failed kicks of this frame, in the order of the robots.
void SoccerGame::listen() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const GameRobot& robot = *robots_[i];
    const FrameRecord& record = robot.record();
    TeamResult& result = results_[static_cast<std::size_t>(robot.team())];
    for (const std::string& text : record.answer.messages) {
      for (std::size_t k = 0; k < robots_.size(); ++k) {
        if (k != i && robots_[k]->team() == robot.team()) network_.send(time_, k, {robot.number(), text});
      }
    }
    for (const FaultRecord& fault : record.faults) {
      ++result.faults;
      note(fmt::format("{} {} has an error in {}: {}", team_name(robot.team()), robot.number(), as_line(fault.script),
                       as_line(fault.fault.message)));
    }
    for (const ActionStatus& action : record.application.actions)
      result.failed_kicks += action.state == ActionState::failed && action.since == record.world.time ? 1 : 0;
  }
}

TeamResult SoccerGame::result(int team) const {
  TeamResult result = results_[static_cast<std::size_t>(team)];
  result.goals = referee_.score()[static_cast<std::size_t>(team)];
  for (const auto& robot : robots_) {
    if (robot->team() != team) continue;
    result.flips += robot->flips();
    result.correct_beliefs += robot->has_correct_belief() ? 1 : 0;
  }
  return result;
}

std::string SoccerGame::digest() const {
  Digest digest;
  for (const auto& robot : robots_) digest.add(std::string_view(robot->digest()));
  return digest.hex();
}

void SoccerGame::note(std::string text) { events_.push_back({time_, std::move(text)}); }

}  // namespace reorient
