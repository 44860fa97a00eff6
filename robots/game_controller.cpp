// SPDX-License-Identifier: MIT
#include "robots/game_controller.h"

#include <algorithm>
#include <bit>
#include <string_view>

namespace reorient {
namespace {

// Offsets, bytes. All three versions start with the same layout, except that byte 8 was the type of the competition in
// 2025, which was always 0.
constexpr std::size_t kVersion = 4, kStopped = 8, kState = 10, kFirstHalf = 12, kKickingTeam = 13, kTeams = 18;
constexpr std::size_t kPlayersOfTeam = 10;  // after the data of the team itself, whose first byte is its number
constexpr int kMostPlayers = 20;

/// Bytes for each player, of which the first is the penalty. Returns 0 for an unknown version.
std::size_t bytes_of_player(std::uint8_t version) {
  switch (version) {
    case 18:
      return 2;
    case 19:
      return 4;
    case 20:
      return 3;
    default:
      return 0;
  }
}

std::optional<GameState> state_of(std::uint8_t number) {
  constexpr std::array kStates{GameState::initial, GameState::ready,    GameState::set,
                               GameState::playing, GameState::finished, GameState::standby};
  if (number >= kStates.size()) return std::nullopt;
  return kStates[number];
}

}  // namespace

bool GameController::read(std::span<const std::byte> datagram, ExternalInputs& external) {
  constexpr std::string_view kHeader = "RGme";
  if (datagram.size() <= kTeams) return false;
  const auto at = [&datagram](std::size_t offset) { return std::to_integer<std::uint8_t>(datagram[offset]); };
  for (std::size_t i = 0; i < kHeader.size(); ++i) {
    if (at(i) != static_cast<std::uint8_t>(kHeader[i])) return false;
  }
  const std::size_t player_bytes = bytes_of_player(at(kVersion));
  const std::size_t team_bytes = kPlayersOfTeam + kMostPlayers * player_bytes;
  const std::optional<GameState> state = state_of(at(kState));
  if (player_bytes == 0 || datagram.size() != kTeams + 2 * team_bytes || !state) return false;
  if (team_ < 1 || player_ < 1 || player_ > kMostPlayers) return false;
  std::size_t ours = kTeams;
  if (at(ours) != team_) ours += team_bytes;
  if (at(ours) != team_) return false;

  RefereeState referee;
  referee.state = *state;
  referee.stopped = at(kStopped) == 1;
  referee.penalized = at(ours + kPlayersOfTeam + static_cast<std::size_t>(player_ - 1) * player_bytes) != 0;
  constexpr int kNoTeam = 255;
  const int kicking = at(kKickingTeam);
  referee.kick_off = kicking == kNoTeam ? KickOff::none : kicking == team_ ? KickOff::ours : KickOff::theirs;
  if (last_ != referee) external.referee = last_ = referee;

  // The half changes only while the ball is not in play: the second half starts, or the operator of the GameController
  // corrects a mistake.
  const bool first_half = at(kFirstHalf) == 1;
  if (!first_half_) first_half_ = first_half;
  if (first_half != *first_half_ && *state != GameState::playing) {
    first_half_ = first_half;
    external.half_time = !external.half_time;
  }
  return true;
}

std::array<std::byte, 32> return_datagram(const GameControllerAnswer& answer) {
  std::array<std::byte, 32> bytes{};
  std::size_t size = 0;
  const auto put = [&](std::uint32_t value, std::size_t count) {  // little-endian
    for (std::size_t i = 0; i < count; ++i) bytes[size++] = static_cast<std::byte>(value >> (8 * i));
  };
  const auto put_float = [&](double value) { put(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); };
  constexpr std::uint8_t kReturnVersion = 4;
  for (const char letter : std::string_view("RGrt")) put(static_cast<std::uint8_t>(letter), 1);
  put(kReturnVersion, 1);
  put(static_cast<std::uint8_t>(answer.player), 1);
  put(static_cast<std::uint8_t>(answer.team), 1);
  put(answer.fallen ? 1 : 0, 1);
  constexpr double kMillimeters = 1000.0;
  put_float(kMillimeters * answer.pose.position.x());
  put_float(kMillimeters * answer.pose.position.y());
  put_float(answer.pose.rotation);
  put_float(-1.0);  // s since the ball was seen; -1: never
  put_float(0.0);
  put_float(0.0);
  return bytes;
}

}  // namespace reorient
