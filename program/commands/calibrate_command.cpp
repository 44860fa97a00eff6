// SPDX-License-Identifier: MIT
// `reorient calibrate`: measures how one robot's cameras are mounted, by field lines at a known pose or by footage.
#include <array>
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/calibrate/footage_calibration.h"
#include "program/calibrate/look_about.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/robots.h"
#include "program/run/nao/nao_hardware.h"
#include "program/run/places.h"
#include "program/run/venue.h"
#include "program/safe_output.h"
#include "program/shell_word.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/calibration_file.h"
#include "workbench/files/field_file.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/scene/camera_overlay.h"

namespace reorient {
namespace {

constexpr std::array<const char*, 2> kCameras{"upper", "lower"};

struct CalibrateOptions {
  std::string robot = kNao;
  std::string at;
  std::filesystem::path body, field, guard;
  std::string cameras = "both";
  int width = 640;
  std::uint64_t seed = 1;
  ParameterOptions parameters;
  std::filesystem::path out = "calibration.toml";
  std::filesystem::path pictures = "out";
  // For footage: the source, how it is read, and the features to use.
  std::filesystem::path source;
  FootageArguments footage;
  std::string by = "auto";
};

std::array<CalibrationShots, 2> look(const CalibrateOptions& options, const RobotBody& body,
                                     const FieldDimensions& field, const Pose2& place, std::ostream& err) {
  if (options.robot != kNao) {
    const RobotOptions robot_options{
        body,   field, "", 1, options.seed, options.width, options.cameras == "both", overrides_of(options.parameters),
        nullptr};
    const RobotInstance robot = make_robot(options.robot, robot_options);
    robot.the_operator->put_down(place);
    return look_about(*robot.robot, robot.body, field);
  }
  NaoHardware hardware({options.guard, options.cameras == "both", false});
  nao::NaoOptions robot_options;
  robot_options.body = body;
  robot_options.width = options.width;
  robot_options.stands_at_once = true;
  nao::Nao robot(robot_options,
                 hardware.surroundings([] { return Interruption::signal() != 0; },
                                       [&err](const std::string& missing) { print_error(err, missing); }));
  return look_about(robot, body, field);
}

void draw_picture(const CalibrationShots& shots, const CameraOffset& offset, const Pose2& robot,
                  const FieldDimensions& field, const std::filesystem::path& file) {
  const CalibrationView& view = shots.views[shots.pictured];
  const pictures::CameraView picture{
      .image = shots.picture.view(),
      .overlay = {
          scene::expected_lines(field, view.camera, to_isometry(robot) * turned(view.robot_from_camera, offset)),
          scene::line_points(view.line_points, view.camera, view.robot_from_camera)}};
  pictures::write_png(file, pictures::draw_camera_view(picture));
}

int calibrate_cameras(const CalibrateOptions& options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  const std::optional<Pose2> place = place_of(options.at);
  NamedFiles files;
  files.reads(options.body, "--body");
  files.reads(options.field, "--field");
  for (const std::filesystem::path& file : parameter_files_of(options.parameters)) files.reads(file, "--params");
  files.require_writable(options.out, "--out");
  const RobotBody body = load_body(body_file(options.body));
  const FieldDimensions field = load_field(field_file(options.field, body));
  const std::array<CalibrationShots, 2> shots = look(options, body, field, *place, err);
  if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());

  Calibration calibration;
  bool any = false;
  std::filesystem::create_directories(options.pictures);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (shots[i].views.empty()) continue;
    const std::optional<CameraCorrection> found = calibrate(shots[i].views, *place, field);
    if (!found) {
      out << kCameras[i]
          << ": expected lines along and across the field at their positions, found too few; check --at and the view "
             "of the "
          << "camera\n";
      continue;
    }
    any = true;
    calibration.offsets[i] = found->offset;
    out << fmt::format(
        "{}: {:+.2f} degrees down, {:+.2f} to the left; lines are off by {:.2f} degrees instead of {:.2f} ({} "
        "of {})\n",
        kCameras[i], to_degrees(found->offset.tilt), to_degrees(found->offset.pan), to_degrees(found->error_after),
        to_degrees(found->error_before), counted(found->points, "point"), counted(shots[i].views.size(), "image"));
    for (const auto& [name, offset] : {std::pair{"before", CameraOffset()}, {"after", found->offset}}) {
      const std::filesystem::path file = options.pictures / fmt::format("calibration_{}_{}.png", kCameras[i], name);
      draw_picture(shots[i], offset, *place, field, file);
      out << "picture: " << as_line(file.string()) << "\n";
    }
  }
  if (!any) return kWrong;
  write_whole_file(options.out, to_toml(calibration));
  out << "written: " << as_line(options.out.string()) << "; reorient run --robot nao --calibration "
      << shell_word(options.out.string()) << "\n";
  return kSuccess;
}

int calibrate_footage(const CalibrateOptions& options, std::ostream& out) {
  NamedFiles files;
  files.reads(options.source, "--footage");
  files.reads(options.body, "--body");
  files.reads(options.field, "--field");
  files.reads(options.footage.table, "--frames");
  files.require_writable(options.out, "--out");
  return calibrate_by_footage({.source = options.source,
                               .footage = options.footage,
                               .body = options.body,
                               .field = options.field,
                               .by = options.by,
                               .out = options.out,
                               .pictures = options.pictures},
                              out);
}

void add_footage(CLI::App& parser, CalibrateOptions& options) {
  CLI::Option* const footage =
      parser.add_option("--footage", options.source, "recorded images: a folder, a video or a log")
          ->type_name("SOURCE")
          ->group(kFootageGroup)
          ->check(check_not_empty);
  parser
      .add_option("--by", options.by,
                  "features to use: lines (field lines; needs poses), edges (vertical in the room) (default: lines if "
                  "seen, else edges)")
      ->type_name("FEATURES")
      ->group(kFootageGroup)
      ->check(CLI::IsMember({"lines", "edges"}))
      ->needs(footage);
  for (const std::string& name : add_footage_reading_options(parser, options.footage))
    parser.get_option(name)->needs(footage);
  for (const char* const name : {"--at", "--robot", "--guard", "--cameras", "--width", "--seed", "--set", "--params"})
    parser.get_option(name)->excludes(footage);
}

}  // namespace

Subcommand add_calibrate(CLI::App& program) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App* const parser =
      program.add_subcommand("calibrate", "measure how a robot's cameras are mounted, by field lines or footage");
  parser->fallthrough();
  set_examples(*parser, {{"reorient calibrate --at -3.2,0,0", "a NAO on the penalty mark, facing the center"},
                         {"reorient calibrate --at -3.2,0,0 --robot simulator", "try it on the simulator"},
                         {"reorient calibrate --footage images", "from recorded images"}});
  constexpr const char* const kGroup = "Robot at a known pose (not with --footage)";
  CLI::Option* const at = parser->add_option("--at", options->at, "pose of the robot in the field frame: m, m, degrees")
                              ->type_name("X,Y,DEGREES")
                              ->group(kGroup)
                              ->check(check_not_empty);
  parser->add_option("--robot", options->robot, "robot whose cameras are calibrated")
      ->type_name("NAME")
      ->group(kGroup)
      ->check(CLI::IsMember({kNao, "simulator"}))
      ->capture_default_str();
  add_body_options(*parser, options->body, options->field);
  parser->add_option("--guard", options->guard, "shared memory of reorient-nao-guard (default: the guard's default)")
      ->type_name("FILE")
      ->group(kGroup)
      ->check(check_not_empty);
  parser->add_option("--cameras", options->cameras, "cameras to calibrate")
      ->type_name("CAMERAS")
      ->group(kGroup)
      ->check(CLI::IsMember({"upper", "both"}))
      ->capture_default_str();
  parser->add_option("--width", options->width, "width of the images in pixels")
      ->type_name("N")
      ->group(kGroup)
      ->check(CLI::IsMember({320, 640}))
      ->capture_default_str();
  parser->add_option("--seed", options->seed, "seed of the simulator's noise")
      ->type_name("N")
      ->group(kGroup)
      ->check(check_seed)
      ->capture_default_str();
  add_parameter_options(*parser, options->parameters);
  for (const char* const name : {"--set", "--params"}) parser->get_option(name)->group(kGroup);
  parser->add_option("--out", options->out, "file to write")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty)
      ->capture_default_str();
  parser->add_option("--pictures", options->pictures, "folder for pictures before and after the calibration")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty)
      ->capture_default_str();
  add_footage(*parser, *options);
  parser->callback([at, options] {
    if (at->empty() && options->source.empty()) throw CLI::RequiredError(at->get_name());
  });
  return {parser, [options](std::ostream& out, std::ostream& err) {
            return options->source.empty() ? calibrate_cameras(*options, out, err) : calibrate_footage(*options, out);
          }};
}

}  // namespace reorient
