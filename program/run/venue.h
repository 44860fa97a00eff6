// SPDX-License-Identifier: MIT
// The room, field and body of a run: from the command line, else from the scenario, else the built-in hall and the
// body's field.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/script/machine/machine_definition.h"
#include "program/run/run_options.h"
#include "robots/application.h"
#include "robots/robot_body.h"

namespace reorient {

/// Extensions of panoramas of rooms.
inline constexpr std::array<std::string_view, 4> kPanoramaExtensions{".hdr", ".png", ".jpg", ".jpeg"};

/// The name of the built-in hall in lists of rooms.
inline constexpr std::string_view kHall = "hall";

struct Venue {
  std::string room;             ///< panorama file; empty: the procedural hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  std::filesystem::path field;

  std::string name() const;  ///< of the room, for the user
};

/// `body`: its field is the default. Throws std::runtime_error with one line if the file of a room or field is missing.
Venue venue_of(const SimulationOptions& options, const ScenarioSetting& setting, const RobotBody& body);

/// A file, or a shipped file by its name; the NAO's for an empty path. Throws std::runtime_error with one line if the
/// file is missing.
std::filesystem::path body_file(const std::filesystem::path& named);
/// The panorama of a room, or a shipped one by its name; not empty. Throws the same.
std::string room_file(const std::string& named);
/// The same for a field; for an empty path the field of the body, if it is known.
std::filesystem::path field_file(const std::filesystem::path& named);
std::filesystem::path field_file(const std::filesystem::path& named, const RobotBody& body);
/// The same for the interface of an application; for an empty path one that declares nothing.
ApplicationInterface interface_named(const std::filesystem::path& named);
/// The shipped bodies, as text: "booster-k1, nao-v6".
std::string known_bodies();

/// The file of a room as a script names it: the name of a shipped one, or a path from the scripts' root; empty for an
/// empty name. Throws std::runtime_error with one line for a file that is neither below the root nor shipped, without
/// looking whether it exists: who runs a script need not have read it.
std::string room_named_by_script(const std::filesystem::path& scripts, const std::string& named);
/// The same for a field, and for the interface of an application.
std::string field_named_by_script(const std::filesystem::path& scripts, const std::string& named);
std::string interface_named_by_script(const std::filesystem::path& scripts, const std::string& named);

}  // namespace reorient
