// SPDX-License-Identifier: MIT
#include "robots/game_controller.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/bytes.h"

namespace reorient {
namespace {

/// Fields of RoboCupGameControlData, with their offsets in bytes, from the header of each version: 18 is that of 2025
/// (RoboCup-SPL/GameController3), 19 and 20 those of 2026 (RoboCup-HumanoidSoccerLeague/GameController).
struct Field {
  std::string_view name;
  std::optional<std::size_t> in_18, in_19, in_20;
};
constexpr std::optional<std::size_t> kMissing;
constexpr std::array kFields{
    Field{"version", 4, 4, 4},
    Field{"packetNumber", 5, 5, 5},
    Field{"playersPerTeam", 6, 6, 6},
    Field{"competitionPhase", 7, kMissing, kMissing},
    Field{"competitionType", 8, 7, 7},
    Field{"stopped", kMissing, 8, 8},
    Field{"gamePhase", 9, 9, 9},
    Field{"state", 10, 10, 10},
    Field{"setPlay", 11, 11, 11},
    Field{"firstHalf", 12, 12, 12},
    Field{"kickingTeam", 13, 13, 13},
    Field{"secsRemaining", 14, 14, 14},
    Field{"secondaryTime", 16, 16, 16},
    Field{"teams[0].teamNumber", 18, 18, 18},
    Field{"teams[0].color of the field players", 19, 19, 19},
    Field{"teams[0].color of the goalkeeper", 20, 20, 20},
    Field{"teams[0].goalkeeper", 21, 21, 21},
    Field{"teams[0].score", 22, 22, 22},
    Field{"teams[0].penaltyShot", 23, 23, 23},
    Field{"teams[0].singleShots", 24, 24, 24},
    Field{"teams[0].messageBudget", 26, 26, 26},
    Field{"teams[0].players[0].penalty", 28, 28, 28},
    Field{"teams[0].players[2].penalty", 32, 36, 34},
    Field{"teams[0].players[2].secsTillUnpenalised", 33, 37, 35},
    Field{"teams[0].players[2].warnings", kMissing, 38, kMissing},
    Field{"teams[0].players[2].cautions", kMissing, 39, 36},
    Field{"teams[1].teamNumber", 68, 108, 88},
    Field{"teams[1].goalkeeper", 71, 111, 91},
    Field{"teams[1].players[0].penalty", 78, 118, 98},
    Field{"teams[1].players[1].penalty", 80, 122, 101},
    Field{"teams[1].players[2].penalty", 82, 126, 104},
    Field{"teams[1].players[2].secsTillUnpenalised", 83, 127, 105},
    Field{"teams[1].players[2].warnings", kMissing, 128, kMissing},
    Field{"teams[1].players[2].cautions", kMissing, 129, 106},
    Field{"teams[1].players[3].penalty", 84, 130, 107},
    Field{"teams[1].players[19].penalty", 116, 194, 155},
};

std::optional<std::size_t> offset_of(std::string_view name, int version) {
  const auto* const field =
      std::find_if(kFields.begin(), kFields.end(), [&](const Field& one) { return one.name == name; });
  if (field == kFields.end()) throw std::logic_error("unknown field " + std::string(name));
  return version == 18 ? field->in_18 : version == 19 ? field->in_19 : field->in_20;
}

/// A datagram of a game.
class Datagram {
 public:
  explicit Datagram(int version) : version_(version), bytes_(version == 18 ? 118 : version == 19 ? 198 : 158) {
    std::memcpy(bytes_.data(), "RGme", 4);
    set("version", version);
    set("firstHalf", 1);
    set("kickingTeam", 255);
    set("teams[0].teamNumber", 7);
    set("teams[1].teamNumber", 5);
  }
  void set(std::string_view field, int value) {
    bytes_.at(*offset_of(field, version_)) = static_cast<std::byte>(value);
  }
  /// As the GameController does if the teams change sides.
  void swap_teams() {
    const std::size_t first = *offset_of("teams[0].teamNumber", version_);
    const std::size_t second = *offset_of("teams[1].teamNumber", version_);
    std::rotate(bytes_.begin() + static_cast<std::ptrdiff_t>(first),
                bytes_.begin() + static_cast<std::ptrdiff_t>(second), bytes_.end());
  }
  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  int version_;
  std::vector<std::byte> bytes_;
};

class EachVersion : public testing::TestWithParam<int> {
 protected:
  /// Whether the teams change sides with this datagram.
  bool changes_sides() {
    external_ = {};
    EXPECT_TRUE(game_.read(datagram_.bytes(), external_)) << game_.take_complaint();
    return external_.half_time;
  }
  bool has_more_states() const { return GetParam() == 18; }

  Datagram datagram_{GetParam()};
  GameController game_{5, 3};
  ExternalInputs external_;
};

TEST_P(EachVersion, ContainsTheStatesOfItsHeader) {
  const GameState states[] = {GameState::initial, GameState::ready,    GameState::set,
                              GameState::playing, GameState::finished, GameState::standby};
  const int count = has_more_states() ? 6 : 5;
  for (int i = 0; i < 256; ++i) {
    datagram_.set("state", i);
    external_ = {};
    EXPECT_EQ(game_.read(datagram_.bytes(), external_), i < count) << i;
    if (i < count) {
      ASSERT_TRUE(external_.referee);
      EXPECT_EQ(external_.referee->state, states[i]);
    } else {
      EXPECT_FALSE(external_.referee);
    }
  }
}

TEST_P(EachVersion, ContainsThePenaltyOfThisPlayer) {
  for (const Field& field : kFields) {
    if (!field.name.ends_with(".penalty")) continue;
    Datagram one(GetParam());
    one.set(field.name, 4);
    ExternalInputs external;
    ASSERT_TRUE(GameController(5, 3).read(one.bytes(), external));
    EXPECT_EQ(external.referee->penalized, field.name == "teams[1].players[2].penalty") << field.name;
    external = {};
    ASSERT_TRUE(GameController(7, 1).read(one.bytes(), external));
    EXPECT_EQ(external.referee->penalized, field.name == "teams[0].players[0].penalty") << field.name;
    external = {};
    ASSERT_TRUE(GameController(5, 20).read(one.bytes(), external));
    EXPECT_EQ(external.referee->penalized, field.name == "teams[1].players[19].penalty") << field.name;
  }
}

TEST_P(EachVersion, StopsAllMotionOnlyWithAFieldOfItsHeader) {
  for (const std::string_view field : {"competitionPhase", "competitionType", "stopped"}) {
    if (!offset_of(field, GetParam())) continue;
    Datagram one(GetParam());
    one.set("state", 3);
    one.set(field, 1);  // a competition of type 1 is "most passes" in 2025, and the middle division later
    ExternalInputs external;
    ASSERT_TRUE(GameController(5, 3).read(one.bytes(), external));
    EXPECT_EQ(external.referee->stopped, field == "stopped") << field;
    EXPECT_EQ(may_walk(*external.referee), field != "stopped") << field;
  }
}

TEST_P(EachVersion, ContainsTheKickOff) {
  const std::pair<int, KickOff> expected[] = {{5, KickOff::ours}, {7, KickOff::theirs}, {255, KickOff::none}};
  for (const auto& [team, kick_off] : expected) {
    datagram_.set("kickingTeam", team);
    external_ = {};
    ExternalInputs external;
    ASSERT_TRUE(GameController(5, 3).read(datagram_.bytes(), external));
    EXPECT_EQ(external.referee->kick_off, kick_off);
  }
}

TEST_P(EachVersion, HasNoEffectByAnyOtherField) {
  const std::string_view used[] = {"version",
                                   "state",
                                   "kickingTeam",
                                   "firstHalf",
                                   "teams[0].teamNumber",
                                   "teams[1].teamNumber",
                                   "teams[1].players[2].penalty",
                                   "stopped"};
  datagram_.set("state", 3);
  ASSERT_FALSE(changes_sides());
  for (const Field& field : kFields) {
    if (!offset_of(field.name, GetParam()) || std::count(std::begin(used), std::end(used), field.name) > 0) continue;
    for (int value = 0; value < 256; ++value) {
      datagram_.set(field.name, value);
      EXPECT_FALSE(changes_sides()) << field.name << " " << value;
      EXPECT_FALSE(external_.referee) << field.name << " " << value << ": it is reported only if it changes";
    }
  }
}

TEST_P(EachVersion, ChangesSidesWithTheHalfInEveryState) {
  for (const bool swaps_teams : {false, true}) {  // programs that imitate the GameController may keep the order
    for (int state = 0; state < 5; ++state) {
      game_ = GameController(5, 3);
      datagram_ = Datagram(GetParam());
      datagram_.set("state", 3);
      EXPECT_FALSE(changes_sides()) << "the first datagram only says where the team plays";
      datagram_.set("firstHalf", 0);
      datagram_.set("state", state);
      if (swaps_teams) datagram_.swap_teams();
      EXPECT_TRUE(changes_sides()) << "the robot may have missed the break; state " << state;
      for (int later = 0; later < 5; ++later) {
        datagram_.set("state", later);
        EXPECT_FALSE(changes_sides()) << "once; state " << later;
      }
    }
  }
}

TEST_P(EachVersion, ChangesSidesOnceIfTheProcessRestartsInTheSecondHalf) {
  ASSERT_FALSE(changes_sides());
  std::vector<std::byte> saved;
  ByteWriter{saved}(game_);
  game_ = GameController();
  ByteReader{saved}(game_);
  datagram_.set("state", 3);
  datagram_.set("firstHalf", 0);
  datagram_.swap_teams();
  EXPECT_TRUE(changes_sides());
  EXPECT_FALSE(changes_sides());
}

TEST_P(EachVersion, ChangesSidesWithTheOrderOfTheTeamsInAShootOut) {
  datagram_.set("firstHalf", 0);
  ASSERT_FALSE(changes_sides());
  datagram_.set("gamePhase", 1);
  EXPECT_FALSE(changes_sides()) << "the first shot is taken at the goal that the others defended";
  for (int shot = 0; shot < 3; ++shot) {
    datagram_.swap_teams();
    EXPECT_TRUE(changes_sides()) << "after each shot; " << shot;
    datagram_.set("state", 2 + shot % 2);
    EXPECT_FALSE(changes_sides());
  }
}

TEST_P(EachVersion, ChangesSidesInExtraTimeWhichHasNoFirstHalf) {
  ASSERT_FALSE(changes_sides());
  const auto next = [&](int phase) {
    datagram_.set("firstHalf", 0);
    datagram_.set("gamePhase", phase);
    datagram_.swap_teams();
    return changes_sides();
  };
  EXPECT_TRUE(next(0));
  EXPECT_TRUE(next(2)) << "the first half of extra time is played as the first half of regular time";
  EXPECT_TRUE(next(2));
  // A robot that missed everything from the first half to extra time.
  datagram_ = Datagram(GetParam());
  game_ = GameController(5, 3);
  ASSERT_FALSE(changes_sides());
  datagram_.set("firstHalf", 0);
  datagram_.set("gamePhase", 2);
  EXPECT_FALSE(changes_sides());
}

TEST_P(EachVersion, IsIgnoredForOtherTeamsAndInvalidPlayers) {
  for (const auto& [team, player] : {std::pair{6, 3}, {5, 21}, {5, 0}, {0, 0}, {255, 1}, {-1, 3}}) {
    EXPECT_FALSE(GameController(team, player).read(datagram_.bytes(), external_)) << team << " " << player;
  }
  EXPECT_FALSE(external_.referee);
}

TEST_P(EachVersion, IsIgnoredIfItsSizeIsWrong) {
  std::vector<std::byte>& bytes = datagram_.bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(game_.read(std::span(bytes).first(size), external_));
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(game_.read(bytes, external_));
  EXPECT_FALSE(external_.referee);
}

INSTANTIATE_TEST_SUITE_P(OfTheGameController, EachVersion, testing::Values(18, 19, 20));

TEST(GameController, ReportsEachReasonToIgnoreADatagramOnce) {
  GameController game(5, 3);
  ExternalInputs external;
  const auto complaint = [&](std::vector<std::byte> bytes) {
    EXPECT_FALSE(game.read(bytes, external));
    return game.take_complaint();
  };
  Datagram unknown(20), others(20), state(20);
  unknown.set("version", 21);
  others.set("teams[1].teamNumber", 9);
  state.set("state", 5);
  std::vector<std::byte> longer = Datagram(19).bytes(), foreign = Datagram(20).bytes();
  longer.push_back(std::byte{0});
  foreign[0] = std::byte{'X'};
  const std::pair<std::vector<std::byte>, std::string> expected[] = {
      {unknown.bytes(), "expected version 18, 19 or 20, found version 21"},
      {others.bytes(), "expected a game of team 5, found one of the teams 7 and 9"},
      {state.bytes(), "expected a state of 0 to 4 for version 20, found 5"},
      {longer, "expected 198 bytes for version 19, found 199"},
      {foreign, "expected the header RGme, found other bytes"}};
  for (const auto& [bytes, text] : expected) EXPECT_EQ(complaint(bytes), "GameController: datagram ignored: " + text);
  for (const auto& [bytes, text] : expected) EXPECT_EQ(complaint(bytes), "") << text << " is reported once";
  unknown.set("version", 0);
  EXPECT_EQ(complaint(unknown.bytes()), "") << "of the same type";
  EXPECT_TRUE(game.read(Datagram(20).bytes(), external));
  EXPECT_EQ(game.take_complaint(), "");
  game.set_robot(5, 21);
  EXPECT_EQ(complaint(Datagram(20).bytes()),
            "GameController: datagram ignored: expected a team of 1 to 254 and a player of 1 to 20, found team 5 and "
            "player 21");
}

TEST(GameController, HasNoEffectWithADatagramThatItIgnores) {
  GameController game(5, 3);
  ExternalInputs external;
  Datagram datagram(20);
  datagram.set("state", 2);
  ASSERT_TRUE(game.read(datagram.bytes(), external));
  Datagram unknown = datagram;
  unknown.set("version", 21);
  unknown.set("state", 3);
  unknown.set("firstHalf", 0);
  external = {};
  EXPECT_FALSE(game.read(unknown.bytes(), external));
  EXPECT_FALSE(external.referee || external.half_time) << "the last state stays valid";
}

RC_GTEST_PROP(GameController, ReportsAStateExactlyIfItAcceptsNoise, (const std::vector<std::uint8_t>& noise)) {
  std::vector<std::byte> bytes = Datagram(20).bytes();
  for (std::size_t i = 0; i < noise.size() && i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(noise[i]);
  ExternalInputs external;
  GameController game(5, 3);
  const bool accepted = game.read(bytes, external);
  RC_ASSERT(accepted == external.referee.has_value());
}

TEST(ReturnDatagram, HasThirtyTwoBytesAndContainsThePoseInMillimeters) {
  const std::array<std::byte, 32> bytes = return_datagram({5, 3, true, Pose2(1.5, -2.0, 0.5)});
  const auto number = [&bytes](std::size_t offset) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) bits |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    return std::bit_cast<float>(bits);
  };
  EXPECT_EQ(std::memcmp(bytes.data(), "RGrt\4\3\5\1", 8), 0);
  EXPECT_EQ(number(8), 1500.0f);
  EXPECT_EQ(number(12), -2000.0f);
  EXPECT_EQ(number(16), 0.5f);
  EXPECT_EQ(number(20), -1.0f);
}

}  // namespace
}  // namespace reorient
