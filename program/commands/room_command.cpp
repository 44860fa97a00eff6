// SPDX-License-Identifier: MIT
// `reorient room rate`: predicts whether room awareness works in a hall, and what would help.
#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/parameter_modules.h"
#include "program/program.h"
#include "program/robots.h"
#include "program/room/learned_room.h"
#include "program/room/rating_text.h"
#include "program/run/engine_setup.h"
#include "program/run/simulation.h"
#include "program/run/venue.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/script_files.h"
#include "workbench/rating/room_rating.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/pictures/rating_view.h"

namespace reorient {
namespace {

struct RoomOptions {
  std::string source;
  std::filesystem::path picture, json;
  Learning learning;
  RatingOptions rating;
  SimulationOptions simulation;
};

RatedRobot rated_robot(const SimulationOptions& options) {
  RatedRobot robot;
  robot.body = load_body(body_file(options.body));
  robot.field = load_field(field_file(options.field, robot.body));
  robot.scripts = read_scripts(options.scripts);
  robot.parameters = overrides_of(options.parameters);
  robot.behaviors = behaviors_for({.head = true, .walk = false, .get_up = true});
  return robot;
}

/// Throws if an override is invalid. Parameters of the engine, scripts and simulator are valid.
void check_rating_parameters(const SimulationOptions& options, const RatedRobot& robot) {
  FrameSetup setup;
  setup.field = robot.field;
  setup.body = robot.body;
  setup.scripts = robot.scripts;
  setup.behaviors = robot.scripts.in_folder("behaviors");
  setup.application = merged(known_interfaces(robot.scripts.root()));
  setup.parameters = robot.parameters;
  RobotOptions simulator;
  simulator.body = robot.body;
  simulator.field = robot.field;
  simulator.parameters = robot.parameters;
  const RecordedBehaviors no_behaviors;
  const ScenarioHost trial(robot.scripts, "scenarios/trial.lua", robot.parameters, no_behaviors, options.seed);
  const std::vector<Parameter> known =
      merged({FrameLoop(setup).parameters(), trial.parameters().list(), robot_parameters(kSimulator, simulator)});
  static_cast<void>(kept_for_others(robot.parameters, {known, {}, all_modules(robot.scripts)}));
}

pictures::RatingView rating_picture(const LearnedRoom& room, const RoomRating& rating, const FieldDimensions& field) {
  pictures::RatingView view;
  view.field = field;
  view.title = "Where the evidence comes from";
  view.notes = {room.from, "verdict: " + verdict_in_words(rating)};
  if (rating.times && rating.times->mean)
    view.notes.push_back(fmt::format("time to correction: mean {:.1f} s", *rating.times->mean));
  const Wall wall(room.model.basis.wall);
  const double half = 0.5 * wall.column_width();
  for (const DirectionRating& one : rating.directions)
    view.sectors.push_back({one.azimuth - half, one.azimuth + half, one.log_odds, one.known});
  if (rating.banner && rating.banner->with) {
    const Banner& banner = rating.banner->banner;
    view.banner = {banner.azimuth, 0.5 * banner.width / wall.radius()};
  }
  return view;
}

int rate_named_room(RoomOptions options, std::ostream& out) {
  const Interruption interruption;
  const auto stop = [] { return Interruption::signal() != 0; };
  options.simulation.scripts = scripts_root(options.simulation.scripts);
  options.simulation.seed = options.rating.seed;
  NamedFiles files;
  files.reads(options.source, "the room");
  files.reads(options.simulation.body, "--body");
  files.reads(options.simulation.field, "--field");
  for (const std::filesystem::path& file : parameter_files_of(options.simulation.parameters))
    files.reads(file, "--params");
  files.reads_scripts(options.simulation.scripts);
  files.require_writable(options.picture, "--picture");
  files.require_writable(options.json, "--json");
  const RatedRobot robot = rated_robot(options.simulation);
  check_rating_parameters(options.simulation, robot);
  const LearnedRoom room = learned_room(options.source, options.learning, options.simulation, stop);
  if (stop()) return exit_code_of(Interruption::signal());
  if (room.model.model.known_tiles() == 0)
    throw std::runtime_error(as_line(options.source) + ": expected a model with learned tiles, found an empty one");
  const RoomRating rating = rate_room(room.model, robot, options.rating, stop);
  if (stop()) return exit_code_of(Interruption::signal());
  print_rating(room, rating, out);
  if (!options.json.empty()) write_whole_file(options.json, rating_as_json(room, rating));
  if (!options.picture.empty()) {
    pictures::write_png(options.picture, pictures::draw_rating(rating_picture(room, rating, robot.field)));
    out << "picture: " << as_line(options.picture.string()) << '\n';
  }
  return rating.verdict == RoomVerdict::works ? kSuccess : kWrong;
}

void add_rate_options(CLI::App& parser, RoomOptions& options) {
  constexpr const char* const kLearning = "Learning a panorama";
  constexpr const char* const kRating = "Rating";
  parser
      .add_option("room", options.source,
                  "panorama (.hdr, .png, .jpg), hall (the built-in hall), saved model, or recording")
      ->type_name("ROOM")
      ->check(check_not_empty)
      ->required();
  parser.add_option("--trials", options.rating.trials, "number of robots that are placed in the room")
      ->type_name("N")
      ->group(kRating)
      ->check(CLI::Range(4, 10'000))
      ->capture_default_str();
  parser
      .add_option("--misfit", options.rating.misfit,
                  "mean Hellinger distance between an observation and the model: 0.35 on another day in hard light, "
                  "0.2 in the same light")
      ->type_name("N")
      ->group(kRating)
      ->check(check_number(0.0, 0.9))
      ->capture_default_str();
  parser.add_option("--banner", options.rating.banner_width, "width of the banner to try in m; 0: none")
      ->type_name("N")
      ->group(kRating)
      ->check(check_number(0.0, 20.0))
      ->capture_default_str();
  parser.add_option("--seed", options.rating.seed, "seed of places, observations and the simulator's noise")
      ->type_name("N")
      ->group(kRating)
      ->check(check_seed)
      ->capture_default_str();
  parser.add_option("--learn", options.learning.seconds, "duration of learning in the robot's seconds")
      ->type_name("SECONDS")
      ->group(kLearning)
      ->check(check_number(1.0, 600.0))
      ->capture_default_str();
  parser.add_flag("--still", options.learning.stands_still, "learn from one place beside the field, without walking")
      ->group(kLearning);
  parser.add_option("--hall-seed", options.simulation.hall_seed, "seed of the built-in hall (default: 1)")
      ->type_name("N")
      ->group(kLearning)
      ->check(check_seed);
  parser.add_option("--picture", options.picture, "draw the directions as a ring into this PNG file")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  parser.add_option("--json", options.json, "write the numbers as JSON")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  add_body_options(parser, options.simulation.body, options.simulation.field);
  add_parameter_options(parser, options.simulation.parameters);
  add_scripts_option(parser, options.simulation.scripts);
}

}  // namespace

Subcommand add_room(CLI::App& program) {
  const auto options = std::make_shared<RoomOptions>();
  CLI::App* const parser = program.add_subcommand("room", "rate a hall: predict how well room awareness works in it");
  parser->fallthrough();
  set_examples(*parser, {{"reorient room rate hall.hdr", "rate a panorama"},
                         {"reorient room rate hall.model", "rate a saved model"}});
  parser->require_subcommand(1);
  CLI::App* const rating =
      parser->add_subcommand("rate", "predict how soon a mirrored pose is corrected, and which directions help");
  rating->fallthrough();
  set_examples(*rating, {{"reorient room rate hall", "rate the built-in hall"},
                         {"reorient room rate hall.hdr --picture ring.png", "rate a panorama and draw it"},
                         {"reorient room rate hall.model --misfit 0.2", "rate a saved model in the same light"}});
  add_rate_options(*rating, *options);
  return {parser, [options](std::ostream& out, std::ostream&) { return rate_named_room(*options, out); }};
}

}  // namespace reorient
