// SPDX-License-Identifier: MIT
// Datagrams of the league's GameController, versions 18 (2025), 19 (spring of 2026) and 20 (summer of 2026), with the
// layout of RoboCupGameControlData.h in its repositories.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "geometry/const_or.h"
#include "robots/robot.h"

namespace reorient {

inline constexpr std::uint16_t kGameControllerPort = 3838;        ///< UDP, broadcast to all robots
inline constexpr std::uint16_t kGameControllerReturnPort = 3939;  ///< UDP, answers to the sender of the datagrams

/// What a datagram contains about the goal that a team defends.
struct TeamSides {
  bool is_first_team = false;    ///< the team comes first in the datagram
  bool is_first_half = false;    ///< of regular time
  bool is_regular_time = false;  ///< neither extra time nor a penalty shoot-out
};
template <typename Visit, ConstOr<TeamSides> T>
void fields(Visit&& visit, T& sides) {
  visit(sides.is_first_team, sides.is_first_half, sides.is_regular_time);
}

/// One robot's view of the game. Ignores datagrams that are not exactly in the expected format or not about this team:
/// then the last state stays valid, which is GameState::unknown until the first datagram is used.
class GameController {
 public:
  /// `team`: number of the team in the league, 1 to 254; `player`: 1 to 20. With other numbers it ignores all
  /// datagrams.
  explicit GameController(int team = 0, int player = 0) : team_(team), player_(player) {}

  int team() const { return team_; }
  int player() const { return player_; }
  /// For another robot: drops what is known about the game.
  void set_robot(int team, int player) {
    team_ = team;
    player_ = player;
    last_.reset();
    sides_.reset();
  }

  /// Adds what has changed to `external`. `external.half_time`: the teams changed sides since the last datagram that
  /// was used, even if that was long ago. Returns false and changes nothing if the datagram is ignored.
  bool read(std::span<const std::byte> datagram, ExternalInputs& external);

  /// One line about the last ignored datagram: what was found and what was expected. Empty if the datagram was used, or
  /// if another datagram was ignored for the same type of reason before.
  std::string take_complaint() { return std::exchange(complaint_, {}); }

  /// Saved, because a half may end while no engine runs.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.team_, self.player_, self.last_, self.sides_);
  }

 private:
  /// Types of reasons to ignore a datagram.
  enum class Reason : unsigned { robot, header, version, size, state, teams };
  bool ignore(Reason reason, const std::function<std::string()>& describe);

  int team_, player_;
  std::optional<RefereeState> last_;
  std::optional<TeamSides> sides_;
  unsigned reported_ = 0;  // one bit for each Reason
  std::string complaint_;
};

/// Answer of a robot on kGameControllerReturnPort: version 4, once or twice a second.
struct GameControllerAnswer {
  int team = 0, player = 0;
  bool fallen = false;
  Pose2 pose;  ///< believed pose in the team's axes, m, rad
};
std::array<std::byte, 32> return_datagram(const GameControllerAnswer& answer);

}  // namespace reorient
