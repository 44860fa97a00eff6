// SPDX-License-Identifier: MIT
// What the league's GameController says of the game: its datagrams, of versions 18 (2025), 19 (spring of 2026) and 20
// (summer of 2026), as RoboCupGameControlData.h of its repositories lays them out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robots/robot.h"

namespace reorient {

inline constexpr std::uint16_t kGameControllerPort = 3838;        ///< UDP, to all
inline constexpr std::uint16_t kGameControllerReturnPort = 3939;  ///< UDP, to whom the datagrams come from

/// One robot's view of the game. Nothing of a datagram is taken that is not of exactly the right form and about this
/// team.
class GameController {
 public:
  /// `team`: as the league numbers it, 1 to 254; `player`: 1 to 20. No game is about any other.
  explicit GameController(int team = 0, int player = 0) : team_(team), player_(player) {}

  int team() const { return team_; }
  int player() const { return player_; }

  /// Adds what is new to `told`; nothing where nothing changed. The teams change sides where a half ends. False: the
  /// datagram is none of the GameController's, or of a game of others.
  bool hear(std::span<const std::byte> datagram, ExternalInputs& external);

  /// A half may end while nobody listens.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.team_, self.player_, self.last_, self.first_half_);
  }

 private:
  int team_, player_;
  std::optional<RefereeState> last_;
  std::optional<bool> first_half_;
};

/// What a robot answers, on kGameControllerReturnPort: version 4, once or twice a second.
struct GameControllerAnswer {
  int team = 0, player = 0;
  bool fallen = false;
  Pose2 pose;  ///< believed, in the team's axes: m, rad
};
std::array<std::byte, 32> return_datagram(const GameControllerAnswer& answer);

}  // namespace reorient
