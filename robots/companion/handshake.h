// SPDX-License-Identifier: MIT
// What a client's hello contains: whose localization is used, which robot it is, its cameras, its field.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "robots/application.h"
#include "robots/companion/message.h"
#include "robots/robot_body.h"

namespace reorient {

/// Loads robots and fields by name; returns nothing for an unknown name.
struct KnownRobots {
  std::function<std::optional<RobotBody>(const std::string& name)> body;
  std::function<std::optional<FieldDimensions>(const std::string& name)> field;
  /// Reads the text of an interface file. Throws std::runtime_error with one line. May be empty: none can be read.
  std::function<ApplicationInterface(std::string_view text, const std::string& name)> interface {};
  ApplicationInterface default_interface{};  ///< of a client that declares none
};

struct Handshake {
  std::uint64_t client = 0;       ///< differs after a restart of the client's process
  bool own_localization = false;  ///< the team's belief is used instead of Reorient's
  bool carries_out_head = false;  ///< requests of behaviors that the robot carries out
  bool carries_out_walk = false;
  bool carries_out_get_up = false;
  double delay = 0.0;  ///< age of an image without a time when it arrives, s
  RobotBody body;
  FieldDimensions field;
  std::array<std::optional<reorient_camera>, 2> cameras;  ///< upper and lower camera
  std::array<Lens, 2> lenses;                             ///< lens of each camera
  ApplicationInterface application;
  bool has_detector = false;              ///< frames may contain percepts of the client's own detector
  bool detector_replaces_vision = false;  ///< these are used instead of the engine's own field vision
};

/// Throws BadMessage.
Handshake read_handshake(std::span<const std::byte> bytes, const KnownRobots& known);

CameraModel camera_model(const reorient_camera& camera, const Lens& lens);

/// Everything on which an engine depends: the robot, its field, the requests that it carries out, and whose
/// localization is used, but not the calibration of its cameras. If two are equal, an engine can continue from the
/// state of the other.
std::vector<std::byte> identity_of(const Handshake& handshake);

}  // namespace reorient
