#include <memory>
#include <ostream>

#include "program/robots.h"
#include "program/run/run_scenario.h"
#include "program/subcommand.h"

namespace reorient {
namespace {

void add_options(CLI::App& run, RunOptions& options) {
  run.add_option("scenario", options.scenario, "scripts/scenarios/NAME.lua, or a path to a file")
      ->capture_default_str();
  run.add_option("--robot", options.robot, "the robot that it is played with")
      ->check(CLI::IsMember(robot_names()))
      ->capture_default_str();
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
      ->check(CLI::IsMember({160, 320, 544, 640}))
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
  run.add_option("--json", options.json, "write the summary into this file, for programs")->check(check_not_empty);
  run.add_option("--seconds", options.seconds, "longest run, in the robot's seconds")
      ->check(check_seconds)
      ->capture_default_str();
  run.add_flag("--every-transition", options.every_transition, "show in the timeline what repeats itself, too");
}

}  // namespace

Subcommand add_run(CLI::App& program) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* const parser = program.add_subcommand("run", "run a scenario on the simulator")->fallthrough();
  add_options(*parser, *options);
  return {parser, [options](std::ostream& out, std::ostream& err) {
            options->scripts = scripts_root(options->scripts);
            return run_scenario(*options, {}, out, err);
          }};
}

}  // namespace reorient
