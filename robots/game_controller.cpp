// SPDX-License-Identifier: MIT
#include "robots/game_controller.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace reorient {
namespace {

// Offsets, bytes. All three versions start with the same layout, except for the bytes 7 and 8: phase and type of the
// competition in version 18, division and `stopped` later.
constexpr std::size_t kVersion = 4, kStopped = 8, kPhase = 9, kState = 10, kFirstHalf = 12, kKickingTeam = 13,
                      kTeams = 18;
constexpr std::size_t kPlayersOfTeam = 10;  // after the data of the team itself, whose first byte is its number
constexpr int kMostPlayers = 20;
constexpr int kMostTeam = 254;  // 255: no team

struct Layout {
  std::uint8_t version;
  std::size_t player_bytes;  // for each player; the first is the penalty
  std::uint8_t states;       // number of known states of the game
  bool has_stopped;

  std::size_t team_bytes() const { return kPlayersOfTeam + kMostPlayers * player_bytes; }
  std::size_t bytes() const { return kTeams + 2 * team_bytes(); }
};
constexpr std::array<Layout, 3> kLayouts{{{18, 2, 6, false}, {19, 4, 5, true}, {20, 3, 5, true}}};

constexpr std::array kStates{GameState::initial, GameState::ready,    GameState::set,
                             GameState::playing, GameState::finished, GameState::standby};

}  // namespace

bool GameController::ignore(Reason reason, const std::function<std::string()>& describe) {
  const unsigned bit = 1u << static_cast<unsigned>(reason);
  if ((reported_ & bit) == 0) complaint_ = "GameController: datagram ignored: " + describe();
  reported_ |= bit;
  return false;
}

bool GameController::read(std::span<const std::byte> datagram, ExternalInputs& external) {
  complaint_.clear();
  constexpr std::string_view kHeader = "RGme";
  const auto at = [&datagram](std::size_t offset) { return std::to_integer<std::uint8_t>(datagram[offset]); };
  const auto number = [&at](std::size_t offset) { return std::to_string(at(offset)); };
  if (team_ < 1 || team_ > kMostTeam || player_ < 1 || player_ > kMostPlayers)
    return ignore(Reason::robot, [&] {
      return "expected a team of 1 to 254 and a player of 1 to 20, found team " + std::to_string(team_) +
             " and player " + std::to_string(player_);
    });
  if (datagram.size() <= kVersion || std::memcmp(datagram.data(), kHeader.data(), kHeader.size()) != 0)
    return ignore(Reason::header, [] { return std::string("expected the header RGme, found other bytes"); });
  const auto* const layout = std::find_if(kLayouts.begin(), kLayouts.end(),
                                          [&](const Layout& known) { return known.version == at(kVersion); });
  if (layout == kLayouts.end())
    return ignore(Reason::version, [&] { return "expected version 18, 19 or 20, found version " + number(kVersion); });
  if (datagram.size() != layout->bytes())
    return ignore(Reason::size, [&] {
      return "expected " + std::to_string(layout->bytes()) + " bytes for version " + number(kVersion) + ", found " +
             std::to_string(datagram.size());
    });
  if (at(kState) >= layout->states)
    return ignore(Reason::state, [&] {
      return "expected a state of 0 to " + std::to_string(layout->states - 1) + " for version " + number(kVersion) +
             ", found " + number(kState);
    });
  const std::size_t second = kTeams + layout->team_bytes();
  const bool is_first_team = at(kTeams) == team_;
  const std::size_t ours = is_first_team ? kTeams : second;
  if (at(ours) != team_)
    return ignore(Reason::teams, [&] {
      return "expected a game of team " + std::to_string(team_) + ", found one of the teams " + number(kTeams) +
             " and " + number(second);
    });

  RefereeState referee;
  referee.state = kStates[at(kState)];
  referee.stopped = layout->has_stopped && at(kStopped) == 1;
  referee.penalized = at(ours + kPlayersOfTeam + static_cast<std::size_t>(player_ - 1) * layout->player_bytes) != 0;
  constexpr int kNoTeam = 255;
  const int kicking = at(kKickingTeam);
  referee.kick_off = kicking == kNoTeam ? KickOff::none : kicking == team_ ? KickOff::ours : KickOff::theirs;
  if (last_ != referee) external.referee = last_ = referee;

  // The GameController puts the team first that defends the left goal, in extra time and in a shoot-out, too, where the
  // number of the half does not change. Programs that imitate it may change only the half. A change counts in every
  // state of the game: the robot may have missed the break.
  constexpr int kShootOut = 1, kExtraTime = 2;
  const bool is_regular_time = at(kPhase) != kShootOut && at(kPhase) != kExtraTime;
  const TeamSides sides{is_first_team, at(kFirstHalf) == 1, is_regular_time};
  const TeamSides before = sides_.value_or(sides);
  const bool is_other_half =
      sides.is_first_half != before.is_first_half && sides.is_regular_time && before.is_regular_time;
  if (sides.is_first_team != before.is_first_team || is_other_half) external.half_time = !external.half_time;
  sides_ = sides;
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
