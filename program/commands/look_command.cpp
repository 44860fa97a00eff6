// SPDX-License-Identifier: MIT
// `reorient look`: what the field vision and the virtual wall see in any picture.
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "geometry/camera_attitude.h"
#include "program/footage/footage_wall.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/look/look_json.h"
#include "program/look/look_pictures.h"
#include "program/look/look_source.h"
#include "program/look/seen_image.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/run/footage_arguments.h"
#include "program/run/places.h"
#include "program/run/venue.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

struct LookOptions {
  std::vector<std::filesystem::path> sources;
  std::filesystem::path body, field;
  FootageArguments footage;
  std::optional<double> pitch_degrees, height;
  std::string at = "0,0,0";
  int every = 1;
  ParameterOptions parameters;
  std::filesystem::path out = "out", json;
};

/// Fits the wall to the footage if --wall requests it.
CoreParameters look_parameters(const LookOptions& options, const RobotBody& body, const FieldDimensions& field) {
  CoreParameters parameters = core_parameters_for(field, body);
  ParameterRegistry registry;
  declare(parameters, registry);
  if (options.footage.wall != "field") {
    if (options.sources.size() > 1)
      throw std::runtime_error("--wall: expected field for several image files, found '" + options.footage.wall + "'");
    FootageArguments arguments = options.footage;
    if (!arguments.images_per_second) arguments.images_per_second = 1.0;
    const auto source = open_footage(options.sources.front(), arguments, body);
    for (const ParameterChange& change : footage_wall(*source, options.footage.wall, field, body).parameters)
      registry.set_early(change);
  }
  set_overrides(options.parameters, registry);
  return parameters;
}

std::string pitch_in_words(const SeenImage& seen) {
  const double used = to_degrees(pitch_of(seen.robot_from_camera));
  if (seen.pitch_source != PitchSource::searched)
    return fmt::format("pitch {:.1f} ({})", used, to_string(seen.pitch_source));
  if (!seen.searched.known) return fmt::format("pitch unknown, {:.1f} assumed", used);
  return fmt::format("pitch {:.1f} +- {:.1f}, roll {:.1f} (searched, {:.0f} %)", used,
                     to_degrees(seen.searched.deviation), to_degrees(roll_of(seen.robot_from_camera)),
                     100.0 * seen.searched.certainty);
}

std::string pitch_in_few_words(const SeenImage& seen) {
  if (!seen.pitch_is_known()) return "pitch unknown";
  return fmt::format("{:.1f} ({})", to_degrees(pitch_of(seen.robot_from_camera)), to_string(seen.pitch_source));
}

std::string percepts_in_words(const SeenImage& seen) {
  return counted(seen.percept.line_points.size(), "line point") + ", " +
         counted(seen.percept.goal_posts.size(), "goal post") + ", " +
         counted(seen.percept.obstacles.size(), "obstacle") + ", " + counted(seen.tiles.size(), "tile") +
         (seen.shows_carpet ? "" : ", no carpet");
}

/// Counts over all images.
struct LookTotals {
  std::size_t images = 0, searched = 0, unknown = 0, without_carpet = 0;

  void add(const SeenImage& seen) {
    ++images;
    searched += seen.pitch_source == PitchSource::searched ? 1 : 0;
    unknown += seen.pitch_is_known() ? 0 : 1;
    without_carpet += seen.shows_carpet ? 0 : 1;
  }
  std::string in_words() const {
    std::string text = counted(images, "image");
    if (searched > 0) text += fmt::format("; pitch searched for in {}, unknown in {}", searched, unknown);
    return text + fmt::format("; no carpet in {}", without_carpet);
  }
};

int look_at_images(const LookOptions& options, std::ostream& out) {
  const Interruption interruption;
  const RobotBody body = load_body(body_file(options.body));
  LookSetup setup;
  setup.field = load_field(field_file(options.field, body));
  setup.level_pitch = pitch_of(robot_from_camera(body.dimensions, {}, {}, body.dimensions.torso_height));
  if (options.pitch_degrees) setup.pitch = from_degrees(*options.pitch_degrees);
  setup.height = options.height;
  setup.pose = place_of(options.at).value_or(Pose2());
  NamedFiles files;
  for (const std::filesystem::path& source : options.sources) files.reads(source, source.string());
  files.reads(options.body, "--camera");
  files.reads(options.field, "--field");
  files.reads(options.footage.table, "--frames");
  for (const std::filesystem::path& file : parameter_files_of(options.parameters)) files.reads(file, "--params");
  files.require_writable(options.json, "--json");
  const std::unique_ptr<LookSource> source = open_look_source(options.sources, options.footage, body);
  setup.parameters = look_parameters(options, body, setup.field);
  require_writable_folder(options.out, "--out");

  std::optional<JsonList> json;
  if (!options.json.empty()) json.emplace(options.json);
  LookPictures pictures(options.out, options.sources, as_line(options.sources.front().string()));
  LookTotals totals;
  LookImage image;
  for (std::size_t i = 0; Interruption::signal() == 0 && source->next(image); ++i) {
    if (i % static_cast<std::size_t>(options.every) != 0) continue;
    const SeenImage seen = see(image, setup);
    const std::string name = as_line(image.frame.name), words = pitch_in_words(seen);
    pictures.add(camera_view_of(image, seen, setup.field), image.frame.name, fmt::format("{}: {}", name, words),
                 fmt::format("{}: {}", as_line(std::filesystem::path(image.frame.name).filename().string()),
                             pitch_in_few_words(seen)));
    if (json) json->add(as_json(image, seen, body));
    out << name << ": " << words << "; " << percepts_in_words(seen) << '\n';
    totals.add(seen);
  }
  pictures.end();
  if (json) json->end();
  out << totals.in_words() << '\n';
  for (const std::filesystem::path& file : pictures.written()) out << "picture: " << as_line(file.string()) << '\n';
  if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());
  if (totals.images == 0) throw std::runtime_error(options.sources.front().string() + ": expected images, found none");
  return kSuccess;
}

}  // namespace

Subcommand add_look(CLI::App& program) {
  const auto options = std::make_shared<LookOptions>();
  options->footage.wall = "field";
  CLI::App* const parser =
      program.add_subcommand("look", "show what the field vision and the wall of tiles see in images");
  parser->fallthrough();
  set_examples(*parser, {{"reorient look photo.jpg", "lines, carpet, posts, obstacles and tiles in an image"},
                         {"reorient look folder --every 10 --json seen.json", "each 10th image of a folder"}});
  parser
      ->add_option("source", options->sources,
                   "image files, or one folder, table (.csv), video, log or recording (.mcap)")
      ->type_name("SOURCE")
      ->check(check_not_empty)
      ->required();
  parser
      ->add_option(
          "--camera", options->body,
          "body whose upper camera took the images: a file, or one of " + known_bodies() + " (default: nao-v6)")
      ->type_name("FILE")
      ->group("Camera")
      ->check(check_not_empty);
  parser
      ->add_option("--pitch", options->pitch_degrees,
                   "pitch of the camera in degrees, positive downward (default: as recorded, else estimated)")
      ->type_name("N")
      ->group("Camera")
      ->check(CLI::Range(-70.0, 70.0));
  parser
      ->add_option("--height", options->height,
                   "height of the camera above the ground in m (default: as recorded, else the standing body's)")
      ->type_name("N")
      ->group("Camera")
      ->check(CLI::Range(0.16, 2.49));
  parser
      ->add_option("--at", options->at,
                   "pose of the robot on the field (m, m, degrees) if none was recorded; selects the tiles in view")
      ->type_name("X,Y,DEGREES")
      ->group("Camera")
      ->check(check_not_empty)
      ->capture_default_str();
  parser
      ->add_option("--field", options->field,
                   "field dimensions: a file, or the name of one in assets/fields (default: the body's)")
      ->type_name("FILE")
      ->group("Camera")
      ->check(check_not_empty);
  parser->add_option("--every", options->every, "use each Nth image only")
      ->type_name("N")
      ->group(kFootageGroup)
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_footage_options(*parser, options->footage);
  add_parameter_options(*parser, options->parameters);
  parser->add_option("--out", options->out, "folder for the pictures")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty)
      ->capture_default_str();
  parser->add_option("--json", options->json, "write what is seen in each image as JSON")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  return {parser, [options](std::ostream& out, std::ostream&) { return look_at_images(*options, out); }};
}

}  // namespace reorient
