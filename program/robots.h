// SPDX-License-Identifier: MIT
// Every robot that the program knows, by name. No other file lists robots.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "geometry/field_dimensions.h"
#include "robots/application.h"
#include "robots/robot_instance.h"
#include "robots/simulator/ball/rolling_ball.h"
#include "robots/simulator/game/collisions.h"
#include "robots/simulator/game/match_referee.h"
#include "robots/simulator/game/team_network.h"
#include "robots/simulator/room/room.h"

namespace reorient {

class Simulator;

/// The last room, cached: many trials use the same room, and decoding a panorama takes as long as a trial.
class RoomCache {
 public:
  /// load_room(file), or procedural_hall() if `file` is empty.
  const Room& room(const std::string& file, std::uint64_t hall_seed, const RoomShape& shape);

 private:
  std::string made_from_;
  Room room_;
};

/// The options of all robots; each robot uses what it needs.
struct RobotOptions {
  RobotBody body;
  FieldDimensions field;
  std::string room;             ///< panorama file; empty: the procedural hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  std::uint64_t seed = 1;       ///< of all noise
  int width = 320;              ///< of a camera's image, pixels
  bool both_cameras = false;    ///< the lower one as well
  std::vector<ParameterChange> parameters;
  RoomCache* rooms = nullptr;          ///< nullptr: each robot creates its own room
  ApplicationInterface application{};  ///< whose application the simulator plays; empty: none
};

/// "simulator", "footage", "companion", "nao".
std::vector<std::string> robot_names();
/// One sentence about the robot. Throws std::runtime_error with one line for an unknown name.
std::string robot_description(const std::string& name);
inline constexpr const char* kSimulator = "simulator";
/// Driven by recorded images; created from a source (program/footage/).
inline constexpr const char* kFootage = "footage";
/// Driven by another program: it is not created, but connects as a client (program/run/companion/).
inline constexpr const char* kCompanion = "companion";
/// A real robot, which scenarios cannot move (program/run/nao/).
inline constexpr const char* kNao = "nao";

/// Throws std::runtime_error with one line: an unknown name, a file that cannot be read, a value out of range.
RobotInstance make_robot(const std::string& name, const RobotOptions& options);

/// The simulator itself, which can label each pixel of its images. Throws the same.
std::unique_ptr<Simulator> make_labeled_simulator(const RobotOptions& options);

/// What the robots of a game share.
struct GameRules {
  MatchParameters match;
  NetworkParameters network;
  CollisionParameters collisions;
  BallParameters ball;
};

/// The simulator of one robot of a game, without other robots of its own. `surroundings_seed`: of light and spectators.
/// Throws the same.
std::unique_ptr<Simulator> make_player(const RobotOptions& options, std::uint64_t surroundings_seed);
GameRules game_rules(const RobotOptions& options);

/// The robot's own parameters with their values; they are fixed during a run.
std::vector<Parameter> robot_parameters(const std::string& name, const RobotOptions& options);

}  // namespace reorient
