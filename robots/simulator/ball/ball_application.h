// SPDX-License-Identifier: MIT
// The simulator as the application of an interface that declares a ball: it sets the values `ball.seen`,
// `ball.position` and `ball.distance`, and carries out the action `kick`. Names that the interface does not declare, or
// declares with another type, are left out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "robots/application.h"
#include "robots/robot.h"
#include "robots/simulator/ball/kick.h"

namespace reorient {

class BallApplication {
 public:
  explicit BallApplication(const ApplicationInterface& declared);

  /// Adds the values of this frame. `ball`: as measured, relative to the robot, m; nothing: the ball is not seen.
  void report_ball(const std::optional<Eigen::Vector2d>& ball, ExternalInputs& external) const;
  /// Begins the last of the kicks.
  void begin(std::span<const StartedAction> actions, Kick& kick);
  /// Stores what is to be reported about the present kick.
  void take(const Kick::Progress& progress);
  /// Adds what take() stored.
  void report_kick(ExternalInputs& external);

 private:
  struct Argument {
    bool is_declared = false;
    std::size_t offset = 0;  // in the numbers or texts of FieldData
  };

  std::optional<std::uint16_t> seen_, position_, distance_, kick_;
  double least_ = 0.0, most_ = 0.0;  // range of ball.distance
  Argument foot_, direction_;
  std::uint32_t id_ = 0;  // of the present kick
  std::vector<ActionReport> reports_;
};

}  // namespace reorient
