// SPDX-License-Identifier: MIT
// The options of `reorient run`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "perception/room/saved_model.h"
#include "program/run/engine_setup.h"
#include "program/run/footage_arguments.h"
#include "program/run/live/live_options.h"
#include "program/run/record_options.h"

namespace reorient {

/// A scenario and its circumstances. The same options give the same run, byte for byte.
struct SimulationOptions : EngineOptions {
  std::string robot = "simulator";              ///< program/robots.h
  std::string scenario = "mirrored_placement";  ///< scripts/scenarios/NAME.lua, or a path to a file
  std::vector<std::string> with;                ///< behaviors to add to those that the scenario lists
  std::vector<std::string> without;             ///< behaviors of the scenario to leave out
  // The venue; the scenario chooses what is not set here (program/run/venue.h).
  std::string room;                        ///< panorama file, or the name of a shipped one
  std::optional<std::uint64_t> hall_seed;  ///< of the procedural hall
  int width = 320;                         ///< of the camera image, pixels; the height is 3/4 of it
  std::string cameras = "upper";           ///< or "both"
  std::filesystem::path model;             ///< of the room, if the file exists; empty: none
  std::optional<SavedModel> learned;       ///< a model of the room, instead of one from a file
  bool sides_changed = false;              ///< the team plays toward the other goal than in the axes of the model
  /// Largest duration in the robot's time. Nothing: kUsualSeconds of a simulation; footage ends by itself.
  std::optional<double> seconds;
  std::map<std::string, std::string> said_at;  ///< of an experiment: file and line of "scenario", of "with head_scan"
};

constexpr double kUsualSeconds = 600.0;

struct RunOptions : SimulationOptions, RecordOptions {
  // Of the companion (program/run/companion/).
  std::filesystem::path socket;  ///< socket for clients; empty: in the user's runtime folder
  std::filesystem::path state;   ///< file of the saved state; empty: beside the socket
  bool fresh = false;            ///< start without the saved state
  // Of the NAO (program/run/nao/).
  std::filesystem::path guard;        ///< memory shared with the guard; empty: its default
  std::string at;                     ///< X,Y,DEGREES, set when the robot stands; empty: not set
  std::filesystem::path places;       ///< TOML file: where players stand before the game begins; empty: none
  std::filesystem::path calibration;  ///< TOML file: mounting of its cameras; empty: the data sheet's
  int team = 0;                       ///< team number in the league; 0: ignore messages of the referee
  int player = 1;
  bool stand = false;  ///< stand up at once, without waiting for the chest button
  bool walk = false;   ///< another program walks, beside the guard
  // Of footage (program/run/footage/), whose source `scenario` names.
  FootageArguments footage;
  std::string
      belief;  ///< from `belief_at` on: right, mirrored, degrees or mirrored:DEGREES; empty: right, and no pose is set
  double belief_at = 0.0;  ///< s
  bool lifted = false;     ///< the belief becomes wrong by lifting the robot, which is not reported
  bool realtime = false;
  std::filesystem::path out = "out";
  bool pictures = true;
  std::filesystem::path json;             ///< empty: no summary for programs
  std::filesystem::path save_parameters;  ///< empty: parameters are not saved
  bool every_transition = false;
  LiveOptions live;
};

}  // namespace reorient
