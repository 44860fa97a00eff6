// Every robot that the program knows, by name. Nothing else names one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "geometry/field_dimensions.h"
#include "robots/robot_instance.h"

namespace reorient {

/// What a robot is made from; each takes what it needs.
struct RobotOptions {
  FieldDimensions field;
  std::string room;             ///< panorama file; empty: the procedural hall
  std::uint64_t hall_seed = 1;  ///< of the procedural hall
  std::uint64_t seed = 1;       ///< of all noise
  int width = 320;              ///< of a camera's image, pixels
  bool both_cameras = false;    ///< the lower one as well
  std::vector<ParameterChange> parameters;
};

/// "simulator".
std::vector<std::string> robot_names();

/// Throws std::runtime_error with one line: a name that is none, a file that cannot be read, a value out of range.
RobotInstance make_robot(const std::string& name, const RobotOptions& options);

/// The robot's own parameters with the values that it is made with; they are fixed while it runs.
std::vector<Parameter> robot_parameters(const std::string& name, const RobotOptions& options);

}  // namespace reorient
