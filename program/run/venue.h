// Where a run takes place: what the command line says, else the scenario, else the shipped hall and field.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/script/machine/machine_definition.h"
#include "program/run/run_options.h"

namespace reorient {

struct Venue {
  std::string room;             ///< panorama file; empty: the procedural hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  std::filesystem::path field;

  std::string name() const;  ///< of the room, for people
};

/// Throws std::runtime_error with one line where a room or field is no file.
Venue venue_of(const SimulationOptions& options, const ScenarioSetting& setting);

/// A file as a script names it: the name of a shipped one, or a path from the scripts' root.
std::string file_named_by_script(const std::filesystem::path& scripts, const std::string& named);

}  // namespace reorient
