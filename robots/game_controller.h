// SPDX-License-Identifier: MIT
// Datagrams of the league's GameController, versions 18 (2025), 19 (spring of 2026) and 20 (summer of 2026), with the
// layout of RoboCupGameControlData.h in its repositories.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robots/robot.h"

namespace reorient {

inline constexpr std::uint16_t kGameControllerPort = 3838;        ///< UDP, broadcast to all robots
inline constexpr std::uint16_t kGameControllerReturnPort = 3939;  ///< UDP, answers to the sender of the datagrams

/// One robot's view of the game. Ignores datagrams that are not exactly in the expected format or not about this team.
class GameController {
 public:
  /// `team`: number of the team in the league, 1 to 254; `player`: 1 to 20. With other numbers it ignores all
  /// datagrams.
  explicit GameController(int team = 0, int player = 0) : team_(team), player_(player) {}

  int team() const { return team_; }
  int player() const { return player_; }

  /// Adds what has changed to `external`. At the end of a half the teams change sides. Returns false if the datagram is
  /// not from a GameController, or about a game of other teams.
  bool read(std::span<const std::byte> datagram, ExternalInputs& external);

  /// Saved, because a half may end while no engine runs.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.team_, self.player_, self.last_, self.first_half_);
  }

 private:
  int team_, player_;
  std::optional<RefereeState> last_;
  std::optional<bool> first_half_;
};

/// Answer of a robot on kGameControllerReturnPort: version 4, once or twice a second.
struct GameControllerAnswer {
  int team = 0, player = 0;
  bool fallen = false;
  Pose2 pose;  ///< believed pose in the team's axes, m, rad
};
std::array<std::byte, 32> return_datagram(const GameControllerAnswer& answer);

}  // namespace reorient
