// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "geometry/image.h"
#include "program/footage/run_footage.h"
#include "program/help.h"
#include "program/named_files.h"
#include "program/robots.h"
#include "program/run/companion/run_companion.h"
#include "program/run/nao/run_nao.h"
#include "program/run/run_scenario.h"
#include "program/subcommand.h"

namespace reorient {
namespace {

constexpr const char* kRunGroup = "Run";

/// Options of the simulator and of all robots.
void add_run_options(CLI::App& run, RunOptions& options) {
  run.add_option("scenario", options.scenario, "scenario: a name in scripts/scenarios, or a file")
      ->type_name("SCENARIO")
      ->capture_default_str();
  run.add_option("--robot", options.robot, "robot")
      ->type_name("NAME")
      ->group(kRunGroup)
      ->check(CLI::IsMember(robot_names()))
      ->capture_default_str();
  run.add_option("--with", options.with, "behavior to add to those of the scenario; repeatable")
      ->type_name("NAME")
      ->group(kRunGroup)
      ->allow_extra_args(false);
  run.add_option("--without", options.without, "behavior of the scenario to leave out; repeatable")
      ->type_name("NAME")
      ->group(kRunGroup)
      ->allow_extra_args(false);
  run.add_option("--behaviors", options.behaviors, "behaviors to run (default: all that the robot supports)")
      ->type_name("A,B,...")
      ->group(kRunGroup)
      ->delimiter(',')
      ->check(check_not_empty);
  run.add_option("--seed", options.seed, "seed of all random numbers")
      ->type_name("N")
      ->group(kRunGroup)
      ->check(check_seed)
      ->capture_default_str();
  run.add_option("--seconds", options.seconds,
                 fmt::format("longest run in the robot's seconds (default: {:g}; footage: all of it)", kUsualSeconds))
      ->type_name("SECONDS")
      ->group(kRunGroup)
      ->check(check_seconds);
  run.add_flag("--realtime", options.realtime, "run in real time; reload saved scripts; Enter opens a prompt")
      ->group(kRunGroup);
  run.add_flag("!--no-room-awareness", options.room_awareness, "switch room awareness off")->group(kRunGroup);
  add_body_options(run, options.body, options.field);
  run.add_option(
         "--interface", options.interface,
         "values and actions of an application: a file, or a name in assets/interfaces (default: the scenario's)")
      ->type_name("FILE")
      ->group(kRunGroup)
      ->check(check_not_empty);
  CLI::Option* const room =
      run.add_option("--room", options.room, "panorama: .hdr, .png or .jpg (default: the scenario's, else a hall)")
          ->type_name("FILE")
          ->group(kRobotGroup)
          ->check(check_not_empty);
  run.add_option("--hall-seed", options.hall_seed, "seed of the built-in hall (default: the scenario's, else 1)")
      ->type_name("N")
      ->group(kRobotGroup)
      ->check(check_seed)
      ->excludes(room);
  run.add_option("--width", options.width, "width of the camera image in pixels")
      ->type_name("N")
      ->group(kRobotGroup)
      ->check(CLI::IsMember(kImageWidths))
      ->capture_default_str();
  run.add_option("--cameras", options.cameras, "cameras in use")
      ->type_name("CAMERAS")
      ->group(kRobotGroup)
      ->check(CLI::IsMember({"upper", "both"}))
      ->capture_default_str();
  CLI::Option* const model =
      run.add_option("--model", options.model, "model of the room: loaded if the file exists, saved after learning")
          ->type_name("FILE")
          ->group(kRobotGroup)
          ->check(check_not_empty);
  run.add_flag("--sides-changed", options.sides_changed,
               "rotate the model by 180 degrees: the team attacks the other goal")
      ->group(kRobotGroup)
      ->needs(model);
  run.add_option("--at", options.at, "pose (m, m, degrees): of a standing NAO, or if footage has no positions")
      ->type_name("X,Y,DEGREES")
      ->group(kRobotGroup)
      ->check(check_not_empty);
}

void add_companion_options(CLI::App& run, RunOptions& options) {
  constexpr const char* const kGroup = "Companion";
  run.add_option("--socket", options.socket, "socket for clients (default: in $XDG_RUNTIME_DIR, else in /tmp)")
      ->type_name("FILE")
      ->group(kGroup)
      ->check(check_not_empty);
  run.add_option("--state", options.state,
                 "file of the saved state, which the next run loads (default: beside the socket)")
      ->type_name("FILE")
      ->group(kGroup)
      ->check(check_not_empty);
  run.add_flag("--fresh", options.fresh, "start without the saved state")->group(kGroup);
}

void add_nao_options(CLI::App& run, RunOptions& options) {
  constexpr const char* const kGroup = "NAO";
  run.add_option("--guard", options.guard, "shared memory of reorient-nao-guard (default: the guard's default)")
      ->type_name("FILE")
      ->group(kGroup)
      ->check(check_not_empty);
  run.add_option("--places", options.places,
                 "file with the initial position of each player, set when the referee starts the state 'initial'")
      ->type_name("FILE")
      ->group(kGroup)
      ->check(check_not_empty);
  run.add_option("--calibration", options.calibration,
                 "file from 'reorient calibrate' (default: the data sheet's angles)")
      ->type_name("FILE")
      ->group(kGroup)
      ->check(check_not_empty);
  run.add_option("--team", options.team, "team number in messages of the GameController (default: ignore the messages)")
      ->type_name("N")
      ->group(kGroup)
      ->check(CLI::Range(1, 254));
  run.add_option("--player", options.player, "player number")
      ->type_name("N")
      ->group(kGroup)
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  run.add_flag("--stand", options.stand, "stand up at once, without waiting for the chest button")->group(kGroup);
  run.add_flag("--walk", options.walk, "let another program walk, beside the guard (docs/on-a-robot.md)")
      ->group(kGroup);
}

void add_belief_options(CLI::App& run, RunOptions& options) {
  constexpr const char* const kGroup = kFootageGroup;
  CLI::Option* const belief =
      run.add_option("--belief", options.belief, "pose to set: right, mirrored, error in degrees, or mirrored:DEGREES")
          ->type_name("POSE")
          ->group(kGroup)
          ->check(check_not_empty);
  run.add_option("--belief-at", options.belief_at, "time in s at which --belief is set")
      ->type_name("SECONDS")
      ->group(kGroup)
      ->check(check_moment)
      ->needs(belief)
      ->capture_default_str();
  run.add_flag("--lifted", options.lifted, "reach --belief by lifting and placing the robot, without setting a pose")
      ->group(kGroup)
      ->needs(belief);
}

void add_output_options(CLI::App& run, RunOptions& options) {
  run.add_option("--save-params", options.save_parameters,
                 "write the parameters that differ from the defaults at the end")
      ->type_name("FILE")
      ->group(kParameterGroup)
      ->check(check_not_empty);
  run.add_option("--out", options.out, "folder for the pictures")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty)
      ->capture_default_str();
  run.add_flag("!--no-pictures", options.pictures, "write no pictures")->group(kOutputGroup);
  run.add_option("--json", options.json, "write the summary as JSON")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  run.add_flag("--every-transition", options.every_transition, "show repeated transitions in the timeline, too")
      ->group(kOutputGroup);
  run.add_option("--record", options.record, "record the run (.mcap) for an exact replay")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  add_record_options(run, options);
}

void add_options(CLI::App& run, RunOptions& options) {
  add_run_options(run, options);
  add_companion_options(run, options);
  add_nao_options(run, options);
  add_belief_options(run, options);
  add_footage_options(run, options.footage);
  add_parameter_options(run, options.parameters);
  add_scripts_option(run, options.scripts);
  add_output_options(run, options);
  add_live_options(run, options.live, kRunGroup);
}

/// A set of robots.
using Robots = unsigned;
constexpr Robots kOfSimulator = 1, kOfFootage = 2, kOfCompanion = 4, kOfNao = 8;
constexpr std::pair<Robots, const char*> kRobots[] = {
    {kOfSimulator, kSimulator}, {kOfFootage, kFootage}, {kOfCompanion, kCompanion}, {kOfNao, kNao}};

/// The robots that use an option. Every robot uses the options that are not listed.
struct OptionUse {
  const char* option;
  Robots robots;
};
constexpr OptionUse kOptionUses[] = {
    {"scenario", kOfSimulator | kOfFootage},
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
    {"--interface", kOfSimulator | kOfCompanion | kOfNao},
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
  std::string names;
  for (const auto& [robot, name] : kRobots) {
    if ((robots & robot) != 0) names.append(names.empty() ? "" : " or ").append(name);
  }
  return "--robot " + names;
}

Robots robots_that_use(const CLI::Option& option) {
  for (const OptionUse& use : kOptionUses) {
    if (option.check_name(use.option)) return use.robots;
  }
  return ~Robots();
}

Robots robot_named(const std::string& name) {
  const auto own =
      std::find_if(std::begin(kRobots), std::end(kRobots), [&](const auto& robot) { return name == robot.second; });
  return own->first;
}

void refuse_unused_options(const CLI::App& run, const std::string& robot) {
  const bool has_scenario = run.get_option("scenario")->count() > 0;
  if ((robot == kCompanion || robot == kNao) && has_scenario)
    throw std::runtime_error("--robot " + robot +
                             ": expected no scenario, since the program cannot move that robot; choose behaviors with "
                             "--behaviors");
  if (robot == kFootage && !has_scenario)
    throw std::runtime_error("--robot footage: expected a source (a folder of images, a video or a log), found none");
  for (const OptionUse& use : kOptionUses) {
    if ((use.robots & robot_named(robot)) != 0 || run.get_option(use.option)->count() == 0) continue;
    if (robot == kCompanion && (use.robots & kOfSimulator) != 0)
      throw std::runtime_error(
          std::string(use.option) +
          ": expected --robot simulator, found --robot companion, whose client describes the robot");
    // Options of the simulator are known best, so it is named alone.
    const Robots users = (use.robots & kOfSimulator) != 0 ? kOfSimulator : use.robots;
    throw std::runtime_error(std::string(use.option) + ": expected " + names_of(users) + ", found --robot " + robot);
  }
}

/// Shows the options that the robot of the command line uses.
class RunHelp : public HelpFormatter {
 public:
  explicit RunHelp(std::shared_ptr<const RunOptions> options) : options_(std::move(options)) {}

  std::vector<HelpPage> pages_of(const CLI::App& app) const override {
    std::vector<HelpPage> pages;
    for (const auto& [robot, name] : kRobots) {
      const auto options = std::make_shared<RunOptions>(*options_);
      options->robot = name;
      pages.push_back(RunHelp(options).page_of(app));
    }
    return pages;
  }

 protected:
  bool is_listed(const CLI::Option& option) const override {
    // The page of footage is full, and the pages of the other robots list it.
    if (options_->robot == kFootage && (option.check_name("--live-allow-origin") || option.check_name("--live-memory")))
      return false;
    return HelpFormatter::is_listed(option) && (robots_that_use(option) & robot_named(options_->robot)) != 0;
  }

  HelpPage::Entry entry_of(const CLI::Option& option) const override {
    if (option.get_positional() && options_->robot == kFootage)
      return {"SOURCE", "folder of images, video or log", true};
    return HelpFormatter::entry_of(option);
  }

  std::string command_of(const CLI::App& app) const override {
    const std::string command = HelpFormatter::command_of(app);
    return options_->robot == kSimulator ? command : command + " --robot " + options_->robot;
  }

  std::string note() const override {
    std::vector<std::string> others;
    for (const auto& [robot, name] : kRobots) {
      if (options_->robot != name) others.emplace_back(name);
    }
    return fmt::format("Options of other robots: reorient run --robot {} --help (also {}, {})", others[0], others[1],
                       others[2]);
  }

  std::string examples_of(const CLI::App& app) const override {
    if (options_->robot == kFootage)
      return examples_text(
          {{"reorient run --robot footage images", "a folder of images"},
           {"reorient run --robot footage log.mcap --belief mirrored", "is the mirrored pose noticed?"}});
    if (options_->robot == kCompanion)
      return examples_text({{"reorient run --robot companion", "wait for the program of a robot"},
                            {"reorient run --robot companion --fresh", "without the saved state"}});
    if (options_->robot == kNao)
      return examples_text({{"reorient run --robot nao --at -3.2,0,0", "on the penalty mark, facing the center"},
                            {"reorient run --robot nao --team 5 --places places.toml", "in a game"}});
    return HelpFormatter::examples_of(app);
  }

 private:
  std::shared_ptr<const RunOptions> options_;
};

/// Each file has one use. Only --save-params may write a file of --params.
void require_different_files(const RunOptions& options) {
  NamedFiles files;
  files.reads_scripts(options.scripts);
  files.reads(options.room, "--room");
  files.reads(options.body, "--body");
  files.reads(options.field, "--field");
  files.reads(options.interface, "--interface");
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
  CLI::App* const parser =
      program.add_subcommand("run", "run a scenario on the simulator, or the engine on another robot")->fallthrough();
  parser->formatter(std::make_shared<RunHelp>(options));
  parser->get_help_ptr()->group(kRunGroup);
  set_examples(*parser, {{"reorient run", "a robot notices that its belief is mirrored"},
                         {"reorient run --seed 7 --room hall.hdr", "other noise, another room"},
                         {"reorient run --no-room-awareness", "the robot does not notice (exit code 1)"},
                         {"reorient run --record run.mcap", "record it, for 'reorient replay run.mcap'"}});
  add_options(*parser, *options);
  return {parser, [parser, options](std::ostream& out, std::ostream& err) {
            options->scripts = scripts_root(options->scripts);
            find_live(*parser, options->live);
            if (parser->get_option("--view-images")->count() > 0) options->live.images = options->view_images;
            options->realtime = options->realtime || options->live.is_on;
            refuse_unused_options(*parser, options->robot);
            require_different_files(*options);
            if (options->robot == kFootage) return run_footage(*options, out, err);
            if (options->robot == kCompanion) return run_companion(*options, out, err);
            if (options->robot == kNao) return run_nao(*options, out, err);
            return run_scenario(*options, {}, out, err);
          }};
}

}  // namespace reorient
