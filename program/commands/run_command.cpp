// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "geometry/image.h"
#include "program/footage/run_footage.h"
#include "program/named_files.h"
#include "program/robots.h"
#include "program/run/companion/run_companion.h"
#include "program/run/nao/run_nao.h"
#include "program/run/run_scenario.h"
#include "program/subcommand.h"

namespace reorient {
namespace {

void add_options(CLI::App& run, RunOptions& options) {
  run.add_option("scenario", options.scenario,
                 "scripts/scenarios/NAME.lua, or a path to a file; footage: a folder of images, a video or a log")
      ->capture_default_str();
  run.add_option("--robot", options.robot, "the robot that it is played with")
      ->check(CLI::IsMember(robot_names()))
      ->capture_default_str();
  run.add_option("--socket", options.socket, "companion: where it listens (default: in $XDG_RUNTIME_DIR, else in /tmp)")
      ->check(check_not_empty);
  run.add_option("--behaviors", options.behaviors,
                 "companion, nao, footage: which behaviors run, as in A,B (default: all that the robot can carry out)")
      ->delimiter(',')
      ->check(check_not_empty);
  run.add_option("--state", options.state,
                 "companion: what it knows is kept here for the next one (default: beside the socket)")
      ->check(check_not_empty);
  run.add_flag("--fresh", options.fresh, "companion: go on from nothing");
  run.add_option("--guard", options.guard, "nao: the memory that reorient-nao-guard shares (default: where it does)")
      ->check(check_not_empty);
  run.add_option("--at", options.at,
                 "nao: where it stands, X,Y,DEGREES; told once it stands; footage without positions: where it starts")
      ->check(check_not_empty);
  add_footage_options(run, options.footage);
  CLI::Option* const belief = run.add_option("--belief", options.belief,
                                             "footage: what the robot is told of its pose: right, mirrored, degrees by "
                                             "which it is wrong, or mirrored:DEGREES")
                                  ->check(check_not_empty);
  run.add_option("--belief-at", options.belief_at, "footage: s, when it is told that")
      ->check(check_moment)
      ->needs(belief)
      ->capture_default_str();
  run.add_flag("--lifted", options.lifted, "footage: it is not told; somebody lifts it then, and puts it down so")
      ->needs(belief);
  run.add_option("--places", options.places,
                 "nao: file that says where each player stands; told when the referee says that the game is in initial")
      ->check(check_not_empty);
  run.add_option("--calibration", options.calibration, "nao: file that says how its cameras are mounted")
      ->check(check_not_empty);
  run.add_option("--team", options.team, "nao: the team's number, by which it hears the GameController")
      ->check(CLI::Range(1, 254));
  run.add_option("--player", options.player, "nao: its number")->check(CLI::Range(1, 20))->capture_default_str();
  run.add_flag("--stand", options.stand, "nao: stand up at once, not when the chest's button is pressed");
  run.add_flag("--walk", options.walk, "nao: a program of yours walks, beside the guard (docs/on-a-robot.md)");
  run.add_option("--with", options.with, "a behaviour beside those of the scenario; may be given again")
      ->allow_extra_args(false);
  run.add_option("--without", options.without, "leave a behaviour of the scenario out; may be given again")
      ->allow_extra_args(false);
  CLI::Option* const room = run.add_option(
      "--room", options.room, "equirectangular panorama: .hdr, .png or .jpg (default: the scenario's, else a hall)");
  room->check(check_not_empty);
  run.add_option("--hall-seed", options.hall_seed, "of the procedural hall (default: the scenario's, else 1)")
      ->check(check_seed)
      ->excludes(room);
  add_body_options(run, options.body, options.field);
  CLI::Option* const model =
      run.add_option("--model", options.model,
                     "file with a model of the room: loaded if it is there, and saved with what this run learns")
          ->check(check_not_empty);
  run.add_flag("--sides-changed", options.sides_changed,
               "the team plays towards the other goal than when the model's file was begun: it is turned")
      ->needs(model);
  run.add_option("--seed", options.seed, "of all noise; one seed, one digest")
      ->check(check_seed)
      ->capture_default_str();
  run.add_option("--width", options.width, "of the camera image, pixels")
      ->check(CLI::IsMember(kImageWidths))
      ->capture_default_str();
  run.add_option("--cameras", options.cameras, "which of the robot's two cameras give images")
      ->check(CLI::IsMember({"upper", "both"}))
      ->capture_default_str();
  run.add_flag("--realtime", options.realtime,
               "at the robot's own pace: scripts are reloaded when they are saved; Enter opens a prompt for commands");
  run.add_flag("!--no-room-awareness", options.room_awareness, "switch the view of the room off");
  add_parameter_options(run, options.parameters);
  run.add_option("--save-params", options.save_parameters,
                 "write what differs from the defaults at the end into this file")
      ->check(check_not_empty);
  add_scripts_option(run, options.scripts);
  run.add_option("--out", options.out, "folder for the pictures")->check(check_not_empty)->capture_default_str();
  run.add_flag("!--no-pictures", options.pictures, "write no pictures");
  run.add_option("--record", options.record, "record the run into this file (.mcap), to be replayed exactly")
      ->check(check_not_empty);
  run.add_option("--record-images", options.record_images, "lossless, every:N (each Nth frame) or none")
      ->capture_default_str();
  run.add_option("--view-images", options.view_images, "of a recording, for viewers: jpeg:Q (quality 1 to 100) or none")
      ->capture_default_str();
  run.add_option("--view-particles", options.view_particles, "the same, of the pose filter: every:N or none")
      ->capture_default_str();
  run.add_option("--record-rotate", options.record_rotate, "begin another file after so much: 500MB, 10min")
      ->check(check_not_empty);
  run.add_option("--json", options.json, "write the summary into this file, for programs")->check(check_not_empty);
  run.add_option(
         "--seconds", options.seconds,
         fmt::format("longest run, in the robot's seconds (default: {:g}; of footage: all of it)", kUsualSeconds))
      ->check(check_seconds);
  run.add_flag("--every-transition", options.every_transition, "show in the timeline what repeats itself, too");
}

/// Robots that heed an option which not every robot does.
using Robots = unsigned;
constexpr Robots kOfSimulator = 1, kOfFootage = 2, kOfCompanion = 4, kOfNao = 8;
constexpr std::pair<Robots, const char*> kRobots[] = {
    {kOfSimulator, kSimulator}, {kOfFootage, kFootage}, {kOfCompanion, kCompanion}, {kOfNao, kNao}};

struct Heeding {
  const char* option;
  Robots robots;
};
constexpr Heeding kHeeding[] = {
    {"--socket", kOfCompanion},
    {"--behaviors", kOfFootage | kOfCompanion | kOfNao},
    {"--state", kOfCompanion},
    {"--fresh", kOfCompanion},
    {"--guard", kOfNao},
    {"--at", kOfFootage | kOfNao},
    {"--places", kOfNao},
    {"--calibration", kOfNao},
    {"--team", kOfNao},
    {"--player", kOfNao},
    {"--stand", kOfNao},
    {"--walk", kOfNao},
    {"--with", kOfSimulator},
    {"--without", kOfSimulator},
    {"--room", kOfSimulator},
    {"--hall-seed", kOfSimulator},
    {"--field", kOfSimulator | kOfFootage | kOfNao},
    {"--body", kOfSimulator | kOfFootage | kOfNao},
    {"--width", kOfSimulator | kOfNao},
    {"--cameras", kOfSimulator | kOfNao},
    {"--realtime", kOfSimulator | kOfFootage},
    {"--save-params", kOfSimulator | kOfFootage},
    {"--out", kOfSimulator | kOfFootage},
    {"--json", kOfSimulator | kOfFootage},
    {"--seconds", kOfSimulator | kOfFootage},
    {"--no-pictures", kOfSimulator | kOfFootage},
    {"--frames", kOfFootage},
    {"--column", kOfFootage},
    {"--fov-degrees", kOfFootage},
    {"--images-per-second", kOfFootage},
    {"--topic", kOfFootage},
    {"--frame", kOfFootage},
    {"--wall", kOfFootage},
    {"--camera-offset", kOfFootage},
    {"--belief", kOfFootage},
    {"--belief-at", kOfFootage},
    {"--lifted", kOfFootage},
};

/// "--robot companion or nao".
std::string names_of(Robots robots) {
  if (robots == kOfSimulator) return "the simulator";
  std::string names;
  for (const auto& [robot, name] : kRobots) {
    if ((robots & robot) != 0) names.append(names.empty() ? "" : " or ").append(name);
  }
  return "--robot " + names;
}

void refuse_in_vain(const CLI::App& run, const std::string& robot) {
  const bool has_scenario = run.get_option("scenario")->count() > 0;
  if ((robot == kCompanion || robot == kNao) && has_scenario)
    throw std::runtime_error(
        "--robot " + robot +
        " plays no scenario, since nobody can carry that robot about; leave it out, and choose with "
        "--behaviors");
  if (robot == kFootage && !has_scenario)
    throw std::runtime_error("--robot footage: name its source: a folder of images, a video or a log");
  const auto own =
      std::find_if(std::begin(kRobots), std::end(kRobots), [&](const auto& one) { return robot == one.second; });
  for (const Heeding& heeding : kHeeding) {
    if ((heeding.robots & own->first) != 0 || run.get_option(heeding.option)->count() == 0) continue;
    if (robot == kCompanion && (heeding.robots & kOfSimulator) != 0)
      throw std::runtime_error(std::string(heeding.option) +
                               ": the companion would not heed it; its client says what robot it is");
    // What the simulator heeds, people expect of it.
    const Robots told = (heeding.robots & kOfSimulator) != 0 ? kOfSimulator : heeding.robots;
    throw std::runtime_error(std::string(heeding.option) + ": only " + names_of(told) + " heeds it");
  }
}

/// Each file has one use. Only what was tuned may go back to where it came from.
void require_different_files(const RunOptions& options) {
  NamedFiles files;
  files.reads_scripts(options.scripts);
  files.reads(options.room, "--room");
  files.reads(options.body, "--body");
  files.reads(options.field, "--field");
  files.reads(options.places, "--places");
  files.reads(options.calibration, "--calibration");
  files.reads(options.footage.table, "--frames");
  files.reads(options.footage.camera_offset, "--camera-offset");
  files.writes(options.save_parameters, "--save-params");
  for (const std::filesystem::path& file : parameter_files_of(options.parameters)) files.reads(file, "--params");
  files.writes(options.model, "--model");
  files.writes(options.state, "--state");
  files.writes(options.json, "--json");
  files.writes(options.record, "--record");
}

}  // namespace

Subcommand add_run(CLI::App& program) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* const parser = program.add_subcommand("run", "run a scenario on the simulator")->fallthrough();
  add_options(*parser, *options);
  return {parser, [parser, options](std::ostream& out, std::ostream& err) {
            options->scripts = scripts_root(options->scripts);
            refuse_in_vain(*parser, options->robot);
            require_different_files(*options);
            if (options->robot == kFootage) return run_footage(*options, out, err);
            if (options->robot == kCompanion) return run_companion(*options, out, err);
            if (options->robot == kNao) return run_nao(*options, out, err);
            return run_scenario(*options, {}, out, err);
          }};
}

}  // namespace reorient
