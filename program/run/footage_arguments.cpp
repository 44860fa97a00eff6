// SPDX-License-Identifier: MIT
#include "program/run/footage_arguments.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "geometry/angle.h"
#include "geometry/camera_offset.h"
#include "geometry/pinned_math.h"
#include "program/options.h"
#include "program/run/recorded_footage.h"
#include "program/shell_word.h"
#include "workbench/files/calibration_file.h"
#include "workbench/footage/decoder_library.h"
#include "workbench/footage/mcap_log.h"

namespace reorient {
namespace {

ColumnHeaders headers_of(const std::vector<std::string>& columns) {
  ColumnHeaders headers;
  const std::vector<std::string> known = frame_column_names();
  for (const std::string& column : columns) {
    const std::size_t equals = column.find('=');
    const std::string name = column.substr(0, equals);
    if (equals == std::string::npos)
      throw BadFootage("--column: expected NAME=HEADER or NAME=HEADER:UNIT, as in time=stamp:ns, found '" + column +
                       "'");
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw BadFootage("--column: unknown column '" + name + "'" + did_you_mean(name, known) + " (expected " +
                       list_of(known) + ")");
    if (!headers.emplace(name, column.substr(equals + 1)).second)
      throw BadFootage("--column: expected different columns, found " + name + " twice");
  }
  return headers;
}

}  // namespace

FootageCamera camera_of(const FootageArguments& arguments, const RobotBody& body) {
  FootageCamera camera{body.upper_camera, standing_camera_height(body)};
  if (!arguments.fov_degrees) return camera;
  CameraOptics& optics = camera.optics;
  optics.field_of_view_horizontal = from_degrees(*arguments.fov_degrees);
  // A pinhole with square pixels replaces the body's camera.
  optics.field_of_view_vertical =
      2.0 * pinned::atan2(pinned::tan(0.5 * optics.field_of_view_horizontal) * optics.height, 1.0 * optics.width);
  static_cast<Lens&>(optics) = Lens();
  optics.center.reset();
  return camera;
}

namespace {

/// Stores the value of an option "KIND=NAME" in the field of that kind.
void take_names(const char* option, const std::vector<std::string>& words,
                const std::map<std::string, std::function<void(const std::string&)>>& places) {
  std::vector<std::string> known;
  known.reserve(places.size());
  for (const auto& [kind, place] : places) known.push_back(kind);
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos)
      throw BadFootage(std::string(option) + ": expected KIND=NAME, found '" + word + "'");
    const auto place = places.find(word.substr(0, equals));
    if (place == places.end())
      throw BadFootage(std::string(option) + ": unknown kind '" + word.substr(0, equals) + "'" +
                       did_you_mean(word.substr(0, equals), known));
    place->second(word.substr(equals + 1));
  }
}

McapLogOptions log_options_of(const FootageArguments& arguments, const RobotBody& body) {
  McapLogOptions options;
  LogTopics& topics = options.topics;
  const auto into = [](std::optional<std::string>& place) {
    return [&place](const std::string& name) { place = name; };
  };
  take_names("--topic", arguments.topics,
             {{"image", into(topics.image)},
              {"camera_info", into(topics.camera_info)},
              {"pose", into(topics.pose)},
              {"odometry", into(topics.odometry)},
              {"imu", into(topics.imu)},
              {"transforms", [&topics](const std::string& name) {
                 if (!topics.transforms) topics.transforms.emplace();
                 if (!name.empty()) topics.transforms->push_back(name);
               }}});
  LogFrameOptions& frames = options.frames;
  const auto name = [](std::string& place) { return [&place](const std::string& text) { place = text; }; };
  take_names("--frame", arguments.frames,
             {{"field", name(frames.field_frame)},
              {"odometry", name(frames.odometry_frame)},
              {"base", name(frames.base_frame)},
              {"camera", name(frames.camera_frame)}});
  frames.decode_image = decoder_library().image;
  if (arguments.fov_degrees) {
    const FootageCamera camera = camera_of(arguments, body);
    frames.camera = camera_of(camera, camera.optics.width, camera.optics.height);
  }
  return options;
}

bool is_log(const std::filesystem::path& source) { return source.extension() == ".mcap"; }

/// As recorded, without the camera offset.
std::unique_ptr<FootageSource> open_recorded(const std::filesystem::path& source, const FootageArguments& arguments,
                                             const RobotBody& body) {
  if (is_log(source)) {
    if (is_recording(source)) return open_recorded_footage(source);
    return std::make_unique<McapLog>(source, log_options_of(arguments, body));
  }
  return open_footage(request_of(source, arguments, body), decoder_library());
}

/// Footage whose recorded camera poses are corrected by a calibration.
class OffsetFootage : public FootageSource {
 public:
  OffsetFootage(std::unique_ptr<FootageSource> source, const Calibration& calibration)
      : source_(std::move(source)), calibration_(calibration) {}

  bool next(FootageFrame& frame) override {
    if (!source_->next(frame)) return false;
    frame.robot_from_camera =
        turned(with_recorded(frame.robot_from_camera, calibration_.recorded), calibration_.offsets[0]);
    return true;
  }

 private:
  std::unique_ptr<FootageSource> source_;
  Calibration calibration_;
};

}  // namespace

std::vector<std::string> add_footage_reading_options(CLI::App& parser, FootageArguments& arguments) {
  parser
      .add_option("--frames", arguments.table, "CSV file with a row for each image (default: frames.csv in the folder)")
      ->type_name("FILE")
      ->group(kFootageGroup)
      ->check(check_not_empty);
  parser
      .add_option("--column", arguments.columns,
                  "header of a CSV column, as in time=stamp:ns; repeatable (docs/footage.md)")
      ->type_name("NAME=HEADER")
      ->group(kFootageGroup)
      ->allow_extra_args(false)
      ->check(check_not_empty);
  parser
      .add_option("--fov-degrees", arguments.fov_degrees,
                  "horizontal field of view, undistorted (default: body's camera)")
      ->type_name("N")
      ->group(kFootageGroup)
      ->check(CLI::Range(10.0, 170.0));
  parser.add_option("--images-per-second", arguments.images_per_second, "constant rate instead of recorded times")
      ->type_name("N")
      ->group(kFootageGroup)
      ->check(CLI::Range(0.01, 1000.0));
  parser.add_option("--topic", arguments.topics, "topic of a log: image, camera_info, transforms, pose, odometry, imu")
      ->type_name("KIND=TOPIC")
      ->group(kFootageGroup)
      ->allow_extra_args(false)
      ->check(check_not_empty);
  parser
      .add_option("--frame", arguments.frames, "frame of a log: field (map), odometry (odom), base (base_link), camera")
      ->type_name("KIND=FRAME")
      ->group(kFootageGroup)
      ->allow_extra_args(false)
      ->check(check_not_empty);
  return {"--frames", "--column", "--fov-degrees", "--images-per-second", "--topic", "--frame"};
}

void add_footage_options(CLI::App& parser, FootageArguments& arguments) {
  add_footage_reading_options(parser, arguments);
  parser.add_option("--wall", arguments.wall, "wall: auto (from the images), field, or a radius in m")
      ->type_name("WALL")
      ->group(kFootageGroup)
      ->check(check_not_empty)
      ->capture_default_str();
  parser
      .add_option("--camera-offset", arguments.camera_offset,
                  "file with the camera's offset, from 'reorient calibrate --footage'")
      ->type_name("FILE")
      ->group(kFootageGroup)
      ->check(check_not_empty);
}

FootageRequest request_of(const std::filesystem::path& source, const FootageArguments& arguments,
                          const RobotBody& body) {
  return {.source = source,
          .table = arguments.table,
          .headers = headers_of(arguments.columns),
          .camera = camera_of(arguments, body),
          .times_are_given = arguments.images_per_second.has_value()};
}

std::unique_ptr<FootageSource> open_footage(const std::filesystem::path& source, const FootageArguments& arguments,
                                            const RobotBody& body) {
  if (arguments.camera_offset.empty()) return open_recorded(source, arguments, body);
  const Calibration calibration = load_calibration(arguments.camera_offset);
  return std::make_unique<OffsetFootage>(open_recorded(source, arguments, body), calibration);
}

std::vector<std::string> unused_columns(const std::filesystem::path& source, const FootageArguments& arguments,
                                        const RobotBody& body) {
  return is_log(source) ? std::vector<std::string>() : unused_columns(request_of(source, arguments, body));
}

std::string words_of(const FootageArguments& arguments) {
  std::string line;
  const auto add = [&line](const char* option, const std::string& value) {
    line.append(" ").append(option).append(" ").append(shell_word(value));
  };
  if (!arguments.table.empty()) add("--frames", arguments.table.string());
  for (const std::string& column : arguments.columns) add("--column", column);
  for (const std::string& topic : arguments.topics) add("--topic", topic);
  for (const std::string& frame : arguments.frames) add("--frame", frame);
  if (arguments.fov_degrees) add("--fov-degrees", fmt::format("{}", *arguments.fov_degrees));
  if (arguments.images_per_second) add("--images-per-second", fmt::format("{}", *arguments.images_per_second));
  if (arguments.wall != FootageArguments().wall) add("--wall", arguments.wall);
  if (!arguments.camera_offset.empty()) add("--camera-offset", arguments.camera_offset.string());
  return line;
}

}  // namespace reorient
