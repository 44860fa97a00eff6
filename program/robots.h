// SPDX-License-Identifier: MIT
// Every robot that the program knows, by name. Nothing else names one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "geometry/field_dimensions.h"
#include "robots/robot_instance.h"
#include "robots/simulator/room/room.h"

namespace reorient {

class Simulator;

/// The room that was made last: many trials take place in one, and to decode a panorama takes as long as a trial.
class RoomCache {
 public:
  /// As load_room() or, where `file` is empty, procedural_hall().
  const Room& room(const std::string& file, std::uint64_t hall_seed, const RoomShape& shape);

 private:
  std::string made_from_;
  Room room_;
};

/// What a robot is made from; each takes what it needs.
struct RobotOptions {
  RobotBody body;
  FieldDimensions field;
  std::string room;             ///< panorama file; empty: the procedural hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  std::uint64_t seed = 1;       ///< of all noise
  int width = 320;              ///< of a camera's image, pixels
  bool both_cameras = false;    ///< the lower one as well
  std::vector<ParameterChange> parameters;
  RoomCache* rooms = nullptr;  ///< nullptr: each robot's room is made anew
};

/// "simulator", "footage", "companion", "nao".
std::vector<std::string> robot_names();
inline constexpr const char* kSimulator = "simulator";
/// That somebody else's images drive: it is made of a source (program/footage/).
inline constexpr const char* kFootage = "footage";
/// That another program drives: it is not made, but waited for (program/run/companion/).
inline constexpr const char* kCompanion = "companion";
/// Nobody can carry it about either (program/run/nao/).
inline constexpr const char* kNao = "nao";

/// Throws std::runtime_error with one line: a name that is none, a file that cannot be read, a value out of range.
RobotInstance make_robot(const std::string& name, const RobotOptions& options);

/// The simulator as itself, which knows what each pixel of its images shows. Throws the same.
std::unique_ptr<Simulator> make_labeled_simulator(const RobotOptions& options);

/// The robot's own parameters with the values that it is made with; they are fixed while it runs.
std::vector<Parameter> robot_parameters(const std::string& name, const RobotOptions& options);

}  // namespace reorient
