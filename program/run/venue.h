// SPDX-License-Identifier: MIT
// Where a run takes place, and with which body: what the command line says, else the scenario, else the shipped hall
// and the body's field.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/script/machine/machine_definition.h"
#include "program/run/run_options.h"
#include "robots/robot_body.h"

namespace reorient {

/// Of files that may be the panorama of a room.
inline constexpr std::array<std::string_view, 4> kPanoramaExtensions{".hdr", ".png", ".jpg", ".jpeg"};

/// The built-in room, where rooms are named.
inline constexpr std::string_view kHall = "hall";

struct Venue {
  std::string room;             ///< panorama file; empty: the procedural hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  std::filesystem::path field;

  std::string name() const;  ///< of the room, for people
};

/// `body`: on whose field it takes place where nothing else is said. Throws std::runtime_error with one line where a
/// room or field is no file.
Venue venue_of(const SimulationOptions& options, const ScenarioSetting& setting, const RobotBody& body);

/// A file, or a shipped one by its name; the NAO's where nothing is named. Throws std::runtime_error with one line
/// where it is none.
std::filesystem::path body_file(const std::filesystem::path& named);
/// The same of a field; where none is named the body's, if it is told.
std::filesystem::path field_file(const std::filesystem::path& named);
std::filesystem::path field_file(const std::filesystem::path& named, const RobotBody& body);
/// Those that are shipped, for people: "booster-k1, nao-v6".
std::string known_bodies();

/// A file as a script names it: the name of a shipped one, or a path from the scripts' root.
std::string file_named_by_script(const std::filesystem::path& scripts, const std::string& named);

}  // namespace reorient
