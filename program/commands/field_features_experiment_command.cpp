// SPDX-License-Identifier: MIT
#include "program/commands/field_features_experiment_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/core_parameters.h"
#include "engine/parameters/counted.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "program/experiment/countdown.h"
#include "program/experiment/outputs/text_table.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/robots.h"
#include "program/run/venue.h"
#include "robots/simulator/simulator.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/simulated_images/look_around.h"

namespace reorient {
namespace {

constexpr const char* kSame = "same";
constexpr int kMostPlaces = 100000;
constexpr double kNear = 3.0;  // m, limit of the first rows of the table

struct FieldFeaturesOptions {
  std::vector<std::string> rooms{std::string(kHall)}, lights{kSame, "hard"};
  std::vector<double> gazes{0.0, 1.0, 3.0};  ///< rad/s
  int places = 30;
  int width = 640;
  std::uint64_t seed = 1;
  std::filesystem::path body, field;
  ParameterOptions parameters;
  std::filesystem::path json;
};

/// A column of the table: all rooms in one light, with one speed of the head.
struct Condition {
  std::string light;
  double gaze = 0.0;
  PerceptScore score;

  std::string name() const { return gaze > 0.0 ? fmt::format("{}, {:g} rad/s", light, gaze) : light + ", still"; }
};

/// The simulator gets its own parameters; the vision gets all others and refuses unknown ones.
struct Tuning {
  RobotOptions robot;
  CoreParameters core;
};

Tuning tuning_of(const FieldFeaturesOptions& options) {
  Tuning tuning;
  tuning.robot.body = load_body(body_file(options.body));
  tuning.robot.field = load_field(field_file(options.field, tuning.robot.body));
  tuning.robot.width = options.width;
  tuning.core = core_parameters_for(tuning.robot.field, tuning.robot.body);
  std::vector<std::string> of_simulator;
  for (const Parameter& parameter : robot_parameters(kSimulator, tuning.robot)) of_simulator.push_back(parameter.name);
  ParameterRegistry registry;
  declare(tuning.core, registry);
  for (const ParameterChange& change : overrides_of(options.parameters)) {
    if (std::find(of_simulator.begin(), of_simulator.end(), change.name) != of_simulator.end()) {
      tuning.robot.parameters.push_back(change);
    } else if (change.origin == ParameterOrigin::command_line) {
      registry.set(change.name, change.value, change.origin);
    } else {
      registry.set_early(change);
    }
  }
  return tuning;
}

PerceptScore look(const Tuning& tuning, const std::string& room, const Condition& condition, std::uint64_t seed,
                  int places, RoomCache& rooms) {
  RobotOptions robot = tuning.robot;
  robot.seed = seed;
  robot.room = room == kHall ? "" : room;
  robot.rooms = &rooms;
  if (condition.light != kSame) {
    ParameterOptions light;
    light.files.emplace_back("light/" + condition.light);
    std::vector<ParameterChange> changes = overrides_of(light);
    changes.insert(changes.end(), robot.parameters.begin(), robot.parameters.end());
    robot.parameters = std::move(changes);
  }
  const std::unique_ptr<Simulator> simulator = make_labeled_simulator(robot);
  FieldFeatures features(tuning.core.field_features, robot.field);
  return look_around(*simulator, features, robot.field, tuning.core.field_features, {places, condition.gaze, seed});
}

std::string share_of(int part, int all) {
  return all > 0 ? fmt::format("{:.2f}", static_cast<double>(part) / all) : "-";
}

std::vector<std::string> row_of(PerceptKind kind, const std::string& distance, const std::vector<Condition>& conditions,
                                double least, double most) {
  PerceptCounts all;
  for (const Condition& condition : conditions) all = all + condition.score.between(kind, least, most);
  std::vector<std::string> row{std::string(kPerceptKinds[static_cast<std::size_t>(kind)]), distance,
                               std::to_string(all.in_view)};
  for (const Condition& condition : conditions) {
    const PerceptCounts counts = condition.score.between(kind, least, most);
    row.push_back(share_of(counts.right, counts.reported) + " " + share_of(counts.found, counts.in_view));
  }
  const bool has_errors = all.right > 0 && kind != PerceptKind::line_points;
  row.push_back(has_errors ? fmt::format("{:.2f}", to_degrees(all.bearing_error / all.right)) : "-");
  row.push_back(has_errors ? fmt::format("{:.1f}", 100.0 * all.distance_error / all.right) : "-");
  row.push_back(all.with_covariance > 0 ? fmt::format("{:.2f}", all.squared_error / all.with_covariance) : "-");
  return row;
}

nlohmann::ordered_json as_json(const Condition& condition) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (std::size_t kind = 0; kind < kPerceptKinds.size(); ++kind) {
    for (std::size_t band = 0; band < PerceptScore::kBands.size(); ++band) {
      const PerceptCounts& counts = condition.score.counts[kind][band];
      if (counts.in_view + counts.reported == 0) continue;
      rows.push_back(
          {{"percept", kPerceptKinds[kind]},
           {"from_m", band > 0 ? PerceptScore::kBands[band - 1] : 0.0},
           {"to_m", PerceptScore::kBands[band]},
           {"in_view", counts.in_view},
           {"found", counts.found},
           {"reported", counts.reported},
           {"right", counts.right},
           {"bearing_error_degrees", counts.right > 0 ? to_degrees(counts.bearing_error / counts.right) : 0.0},
           {"distance_error_share", counts.right > 0 ? counts.distance_error / counts.right : 0.0},
           {"with_covariance", counts.with_covariance},
           {"squared_error", counts.with_covariance > 0 ? counts.squared_error / counts.with_covariance : 0.0}});
    }
  }
  return {{"light", condition.light},
          {"gaze_rad_per_s", condition.gaze},
          {"images", condition.score.images},
          {"rows", std::move(rows)}};
}

void print(const std::vector<Condition>& conditions, bool has_corner_arcs, std::ostream& out) {
  TextTable table{{"percept", "distance, m", "in view"}};
  for (const Condition& condition : conditions) table[0].push_back(condition.name());
  for (const char* title : {"bearing, degrees", "distance, %", "spread"}) table[0].emplace_back(title);
  for (std::size_t i = 0; i < kPerceptKinds.size(); ++i) {
    const auto kind = static_cast<PerceptKind>(i);
    if (kind == PerceptKind::corner_arcs && !has_corner_arcs) continue;
    table.push_back(row_of(kind, fmt::format("to {:g}", kNear), conditions, 0.0, kNear));
  }
  for (std::size_t i = 0; i < kPerceptKinds.size(); ++i) {
    double from = 0.0;
    for (const double to : PerceptScore::kBands) {
      std::vector<std::string> row =
          row_of(static_cast<PerceptKind>(i), fmt::format("{:g} to {:g}", from, to), conditions, from, to);
      from = to;
      if (row[2] != "0") table.push_back(std::move(row));
    }
  }
  print_table(table, 1, out);
}

int run(const FieldFeaturesOptions& options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  NamedFiles named;
  for (const std::string& room : options.rooms) {
    if (room != kHall) named.reads(room, "--rooms");
  }
  for (const std::filesystem::path& file : parameter_files_of(options.parameters)) named.reads(file, "--params");
  named.require_writable(options.json, "--json");
  const Tuning tuning = tuning_of(options);
  std::vector<Condition> conditions;
  for (const std::string& light : options.lights) {
    for (const double gaze : options.gazes) conditions.push_back({light, gaze, {}});
  }
  RoomCache rooms;
  {
    Countdown countdown(err, options.rooms.size() * conditions.size());
    std::uint64_t seed = options.seed;  // each room and condition has different places
    for (const std::string& room : options.rooms) {
      for (Condition& condition : conditions) {
        if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());
        condition.score = condition.score + look(tuning, room, condition, seed++, options.places, rooms);
        countdown.count();
      }
    }
  }
  if (!options.json.empty()) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Condition& condition : conditions) json.push_back(as_json(condition));
    write_whole_file(options.json, json.dump(1) + "\n");
  }
  out << fmt::format("{} images of {} pixels a row, in each of {}\n\n", 3 * options.places, options.width,
                     counted(options.rooms.size(), "room"));
  print(conditions, tuning.robot.field.corner_arc_radius > 0.0, out);
  out << "\nIn each light and at each speed of the head: precision, then recall. bearing, distance: mean error of what "
         "is right. spread: its squared error, normalized by its covariance; 2 where the covariance is right.\n";
  return kSuccess;
}

}  // namespace

Subcommand add_field_features_experiment(CLI::App& experiment) {
  constexpr const char* const kImages = "Images";
  const auto options = std::make_shared<FieldFeaturesOptions>();
  CLI::App* const parser = experiment.add_subcommand("field_features", "score the field vision on simulated images");
  set_examples(*parser, {{"reorient experiment field_features --places 10", "10 places in each room"},
                         {"reorient experiment field_features --gaze-speeds 0 2", "with a still and a turning head"}});
  parser->add_option("--rooms", options->rooms, "panoramas; hall: the built-in hall")
      ->type_name("FILE")
      ->group(kImages)
      ->check(check_not_empty)
      ->capture_default_str();
  parser->add_option("--lights", options->lights, "same, or names of files in assets/parameters/light")
      ->type_name("NAME")
      ->group(kImages)
      ->check(check_not_empty)
      ->capture_default_str();
  parser->add_option("--gaze-speeds", options->gazes, "rotation speeds of the head in rad/s; 0: still")
      ->type_name("N")
      ->group(kImages)
      ->check(check_number(0.0, 5.0))
      ->capture_default_str();
  parser->add_option("--places", options->places, "number of places, with three images from each")
      ->type_name("N")
      ->group(kImages)
      ->check(CLI::Range(1, kMostPlaces))
      ->capture_default_str();
  parser->add_option("--width", options->width, "width of the camera image in pixels")
      ->type_name("N")
      ->group(kImages)
      ->check(CLI::Range(80, 1280))
      ->capture_default_str();
  parser->add_option("--seed", options->seed, "seed of the first room and condition; then the next numbers")
      ->type_name("N")
      ->group(kImages)
      ->check(check_seed)
      ->capture_default_str();
  add_body_options(*parser, options->body, options->field);
  add_parameter_options(*parser, options->parameters);
  parser->add_option("--json", options->json, "write all counts as JSON")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  return {parser, [options](std::ostream& out, std::ostream& err) { return run(*options, out, err); }};
}

}  // namespace reorient
