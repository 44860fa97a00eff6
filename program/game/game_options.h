// SPDX-License-Identifier: MIT
// The options of `reorient game`.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "program/options.h"
#include "program/run/record_options.h"

namespace reorient {

struct TeamOptions {
  std::filesystem::path scripts;       ///< root of the scripts
  std::vector<std::string> behaviors;  ///< empty: those that play soccer
};

struct GameOptions {
  int robots = 5;  ///< in each team
  double seconds = 300.0;
  std::uint64_t seed = 1;
  int width = 160;              ///< of the camera image, pixels
  std::filesystem::path body;   ///< TOML file, or the name of a shipped one; empty: the NAO
  std::filesystem::path field;  ///< TOML file, or the name of a shipped one; empty: the body's
  std::filesystem::path interface = "ball";
  std::string room;             ///< panorama file, or the name of a shipped one; empty: the hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  bool room_awareness = true;
  int threads = 2;
  ParameterOptions parameters;  ///< of all robots
  std::array<TeamOptions, 2> teams;
  RecordOptions recording;  ///< of each robot, into the folder RecordOptions::record
};

}  // namespace reorient
