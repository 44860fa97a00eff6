// SPDX-License-Identifier: MIT
// The options of all commands that read footage.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robots/footage/footage.h"
#include "robots/robot_body.h"
#include "workbench/footage/open_footage.h"

namespace CLI {
class App;
}

namespace reorient {

struct FootageArguments {
  std::filesystem::path table;        ///< CSV; empty: the usual one
  std::vector<std::string> columns;   ///< NAME=HEADER or NAME=HEADER:UNIT
  std::optional<double> fov_degrees;  ///< horizontal field of view; nothing: the body's
  std::optional<double> images_per_second;
  std::vector<std::string> topics;      ///< of a log: KIND=TOPIC
  std::vector<std::string> frames;      ///< of a log: KIND=FRAME
  std::string wall = "auto";            ///< or "field", or a radius in m
  std::filesystem::path camera_offset;  ///< TOML, by `reorient calibrate --footage`; empty: none
};

void add_footage_options(CLI::App& parser, FootageArguments& arguments);
/// The options that set how the footage is read; returns their names.
std::vector<std::string> add_footage_reading_options(CLI::App& parser, FootageArguments& arguments);

/// The camera of images without a calibration: --fov-degrees, else the body's upper camera.
FootageCamera camera_of(const FootageArguments& arguments, const RobotBody& body);
/// The request for a folder, a table or a video. Throws BadFootage with one line.
FootageRequest request_of(const std::filesystem::path& source, const FootageArguments& arguments,
                          const RobotBody& body);

/// With the camera offset applied. Throws std::runtime_error (mostly BadFootage) with one line.
std::unique_ptr<FootageSource> open_footage(const std::filesystem::path& source, const FootageArguments& arguments,
                                            const RobotBody& body);

/// Headers of the table that are not used; empty without a table. Throws BadFootage with one line.
std::vector<std::string> unused_columns(const std::filesystem::path& source, const FootageArguments& arguments,
                                        const RobotBody& body);

/// The same arguments on a command line, each after a space.
std::string words_of(const FootageArguments& arguments);

}  // namespace reorient
