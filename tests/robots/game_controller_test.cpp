// SPDX-License-Identifier: MIT
#include "robots/game_controller.h"

#include <bit>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

/// A datagram of a game between teams 7 and 5, otherwise without information.
std::vector<std::byte> datagram(int version) {
  const std::size_t player_bytes = version == 18 ? 2 : version == 19 ? 4 : 3;
  std::vector<std::byte> bytes(18 + 2 * (10 + 20 * player_bytes));
  std::memcpy(bytes.data(), "RGme", 4);
  bytes[4] = static_cast<std::byte>(version);
  bytes[12] = std::byte{1};  // first half
  bytes[13] = std::byte{255};
  bytes[18] = std::byte{7};
  bytes[18 + 10 + 20 * player_bytes] = std::byte{5};
  return bytes;
}

class EachVersion : public testing::TestWithParam<int> {
 protected:
  std::size_t size_of_player() const { return GetParam() == 18 ? 2 : GetParam() == 19 ? 4 : 3; }
  std::size_t our_players() const { return 18 + 10 + 20 * size_of_player() + 10; }

  std::vector<std::byte> bytes_ = datagram(GetParam());
  GameController game_{5, 3};
  ExternalInputs external_;
};

TEST_P(EachVersion, HasTheSizeOfTheLeaguesDefinition) {
  EXPECT_EQ(bytes_.size(), GetParam() == 18 ? 118u : GetParam() == 19 ? 198u : 158u);
}

TEST_P(EachVersion, ContainsTheStateOfTheGame) {
  const GameState states[] = {GameState::initial, GameState::ready,    GameState::set,
                              GameState::playing, GameState::finished, GameState::standby};
  for (std::size_t i = 0; i < std::size(states); ++i) {
    bytes_[10] = static_cast<std::byte>(i);
    ASSERT_TRUE(game_.read(bytes_, external_));
    EXPECT_EQ(external_.referee->state, states[i]);
  }
  bytes_[10] = std::byte{6};
  EXPECT_FALSE(game_.read(bytes_, external_));
}

TEST_P(EachVersion, ContainsThePenaltyOfThisPlayer) {
  for (std::size_t player = 0; player < 20; ++player) {
    std::vector<std::byte> one = bytes_;
    one[our_players() + player * size_of_player()] = std::byte{4};
    ExternalInputs external;
    GameController game(5, 3);
    ASSERT_TRUE(game.read(one, external));
    EXPECT_EQ(external.referee->penalized, player == 2);
  }
}

TEST_P(EachVersion, ContainsTheStopOfAllMotionAndTheKickOff) {
  bytes_[8] = std::byte{1};
  bytes_[13] = std::byte{5};
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_TRUE(external_.referee->stopped);
  EXPECT_EQ(external_.referee->kick_off, KickOff::ours);
  bytes_[13] = std::byte{7};
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_EQ(external_.referee->kick_off, KickOff::theirs);
}

TEST_P(EachVersion, IsReportedOnlyIfItChanges) {
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_TRUE(external_.referee);
  external_ = {};
  bytes_[5] = std::byte{9};  // number of the datagram
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_FALSE(external_.referee);
}

TEST_P(EachVersion, ChangesSidesWithTheHalfButNotDuringPlay) {
  bytes_[10] = std::byte{3};
  ASSERT_TRUE(game_.read(bytes_, external_));
  bytes_[12] = std::byte{0};
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_FALSE(external_.half_time) << "the half does not change during play";
  bytes_[10] = std::byte{0};
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_TRUE(external_.half_time);
  external_ = {};
  ASSERT_TRUE(game_.read(bytes_, external_));
  EXPECT_FALSE(external_.half_time);
}

TEST_P(EachVersion, IsIgnoredForOtherTeamsAndInvalidPlayers) {
  EXPECT_FALSE(GameController(6, 3).read(bytes_, external_));
  EXPECT_FALSE(GameController(5, 21).read(bytes_, external_));
  EXPECT_FALSE(GameController().read(bytes_, external_));
  EXPECT_FALSE(external_.referee);
}

TEST_P(EachVersion, IsIgnoredIfItsSizeIsWrong) {
  for (std::size_t size = 0; size < bytes_.size(); ++size)
    EXPECT_FALSE(game_.read(std::span(bytes_).first(size), external_));
  bytes_.push_back(std::byte{0});
  EXPECT_FALSE(game_.read(bytes_, external_));
  EXPECT_FALSE(external_.referee);
}

INSTANTIATE_TEST_SUITE_P(OfTheGameController, EachVersion, testing::Values(18, 19, 20));

TEST(GameController, IgnoresAnUnknownVersion) {
  std::vector<std::byte> bytes = datagram(20);
  for (const int version : {0, 12, 17, 21, 255}) {
    bytes[4] = static_cast<std::byte>(version);
    ExternalInputs external;
    EXPECT_FALSE(GameController(5, 1).read(bytes, external));
  }
}

RC_GTEST_PROP(GameController, ReportsAStateExactlyIfItAcceptsNoise, (const std::vector<std::uint8_t>& noise)) {
  std::vector<std::byte> bytes = datagram(20);
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
