// SPDX-License-Identifier: MIT
// What `reorient run` was asked to do.
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

namespace reorient {

/// A scenario and its circumstances: the same ones give the same run, byte for byte.
struct SimulationOptions : EngineOptions {
  std::string robot = "simulator";              ///< program/robots.h
  std::string scenario = "mirrored_placement";  ///< scripts/scenarios/NAME.lua, or a path to a file
  std::vector<std::string> with;                ///< behaviours beside those that the scenario lists
  std::vector<std::string> without;             ///< of those that the scenario lists
  // Where it takes place; what is left open here is up to the scenario (program/run/venue.h).
  std::string room;                        ///< panorama file, or the name of a shipped one
  std::optional<std::uint64_t> hall_seed;  ///< of the procedural hall
  int width = 320;                         ///< of the camera image, pixels; the height is 3/4 of it
  std::string cameras = "upper";           ///< or "both"
  std::filesystem::path model;             ///< of the room, if the file is there; empty: none
  std::optional<SavedModel> learned;       ///< a model of the room, instead of one from a file
  bool sides_changed = false;              ///< the team plays towards the other goal than the model's axes say
  /// Of the robot's time, at most. Nothing: kUsualSeconds of a simulation; footage ends by itself.
  std::optional<double> seconds;
  std::map<std::string, std::string> said_at;  ///< of an experiment: file and line of "scenario", of "with head_scan"
};

constexpr double kUsualSeconds = 600.0;

struct RunOptions : SimulationOptions {
  // Of the companion (program/run/companion/).
  std::filesystem::path socket;  ///< at which it listens; empty: in the user's own folder for such things
  std::filesystem::path state;   ///< what it goes on from; empty: beside the socket
  bool fresh = false;            ///< it goes on from nothing
  // Of the NAO (program/run/nao/).
  std::filesystem::path guard;        ///< the memory that is shared with it; empty: where it is by itself
  std::string at;                     ///< X,Y,DEGREES, told once it stands; empty: nobody tells it
  std::filesystem::path places;       ///< TOML file: where players stand before the game begins; empty: none
  std::filesystem::path calibration;  ///< TOML file: how its cameras are mounted; empty: as the data sheet says
  int team = 0;                       ///< as the league numbers it; 0: the referee is not heard
  int player = 1;
  bool stand = false;  ///< up at once, not when the chest's button is pressed
  bool walk = false;   ///< somebody else's program walks, beside the guard
  // Of footage (program/run/footage/), whose source `scenario` names.
  FootageArguments footage;
  std::string
      belief;  ///< from `belief_at` on: right, mirrored, degrees or mirrored:DEGREES; empty: right, and nobody says so
  double belief_at = 0.0;  ///< s
  bool lifted = false;     ///< the belief changes while somebody lifts the robot
  bool realtime = false;
  std::filesystem::path record;  ///< the recording; empty: none
  std::string record_rotate;     ///< "100MB", "10min"; empty: one file
  // program/run/run_recording.h
  std::string record_images = "lossless";
  std::string view_images = "jpeg:75";
  std::string view_particles = "every:6";
  std::filesystem::path out = "out";
  bool pictures = true;
  std::filesystem::path json;             ///< empty: no summary for programs
  std::filesystem::path save_parameters;  ///< empty: what was tuned is not saved
  bool every_transition = false;
};

}  // namespace reorient
