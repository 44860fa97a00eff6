// What `reorient run` was asked to do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace reorient {

struct RunOptions {
  std::string scenario = "turned_round";  ///< scripts/scenarios/NAME.lua, or a path to a file
  std::filesystem::path scripts;          ///< root of the scripts
  std::filesystem::path field;            ///< TOML file
  std::string room;                       ///< panorama file; empty: the procedural hall
  std::uint64_t hall = 1;                 ///< seed of the procedural hall
  std::uint64_t seed = 1;
  int width = 320;  ///< of the camera image, pixels; the height is 3/4 of it
  bool realtime = false;
  bool room_awareness = true;
  std::filesystem::path out = "out";
  bool pictures = true;
  std::filesystem::path json;    ///< empty: no summary for programs
  std::vector<std::string> set;  ///< NAME=VALUE
  std::vector<std::filesystem::path> parameter_files;
  double seconds = 600.0;  ///< of the robot's time, at most
  bool every_transition = false;
};

}  // namespace reorient
