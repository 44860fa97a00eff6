// SPDX-License-Identifier: MIT
// What a client says of itself, once: whose localization counts, which robot it is, its cameras, its field.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "robots/companion/message.h"
#include "robots/robot_body.h"

namespace reorient {

/// Robots and fields that have a name here; nothing: there is none of this name.
struct KnownRobots {
  std::function<std::optional<RobotBody>(const std::string& name)> body;
  std::function<std::optional<FieldDimensions>(const std::string& name)> field;
};

struct Handshake {
  std::uint64_t client = 0;       ///< another one where the client's process has begun anew
  bool own_localization = false;  ///< the team's belief counts, and ours rests
  bool carries_out_head = false;  ///< what the robot does of what behaviours ask for
  bool carries_out_walk = false;
  bool carries_out_get_up = false;
  double delay = 0.0;  ///< s that an image without a time is old when it arrives
  RobotBody body;
  FieldDimensions field;
  std::array<std::optional<reorient_camera>, 2> cameras;  ///< the upper and the lower one
  std::array<Lens, 2> lenses;                             ///< of each
};

/// Throws BadMessage.
Handshake read_handshake(std::span<const std::byte> bytes, const KnownRobots& known);

CameraModel camera_model(const reorient_camera& camera, const Lens& lens);

/// All that an engine is made for: the robot, its field, what it carries out and whose localization counts; not how its
/// cameras are calibrated. Where two are equal, an engine can go on from the one with the other.
std::vector<std::byte> identity_of(const Handshake& handshake);

}  // namespace reorient
