// SPDX-License-Identifier: MIT
#include "robots/companion/companion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include "geometry/bytes.h"
#include "robots/companion/connection.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class CompanionTest : public ::testing::Test {
 protected:
  CompanionTest() { companion_.emplace(options()); }

  CompanionOptions options() {
    return {folder_.path() / "socket",
            no_known_robots(),
            77,
            [this] { return now_; },
            [this] { return ++looks_ > 3; },
            0.0,
            [this](const std::string& line) { told_.push_back(line); }};
  }

  /// One frame, if one has arrived.
  std::optional<Observation> observed() {
    looks_ = 0;
    Observation observation;
    if (!companion_->observe(observation)) return std::nullopt;
    return observation;
  }

  RawClient greeted(const reorient_hello& hello = small_hello(), bool continues = false) {
    RawClient client(folder_.path() / "socket");
    client.introduce(hello);
    looks_ = 0;
    const Handshake* const handshake = companion_->wait_for_handshake();
    EXPECT_NE(handshake, nullptr);
    if (handshake != nullptr && !begun_) companion_->begin(*handshake, continues, 3);
    begun_ = true;
    static_cast<void>(observed());  // takes the memory
    return client;
  }

  TemporaryFolder folder_;
  double now_ = 1000.0;
  int looks_ = 0;
  bool begun_ = false;
  std::vector<std::string> told_;  // lines for the operator
  std::optional<Companion> companion_;
};

/// A datagram of the GameController, sent by the third player of team 5.
reorient_game game_of(bool first_half) {
  reorient_game game{};
  game.team = 5;
  game.player = 3;
  game.size = 158;
  std::memcpy(game.datagram, "RGme", 4);
  game.datagram[4] = 20;
  game.datagram[10] = 2;  // set
  game.datagram[13] = 5;  // we kick off
  game.datagram[12] = first_half ? 1 : 0;
  game.datagram[18 + 70] = 5;  // we are the second team
  return game;
}

TEST_F(CompanionTest, ReceivesTheGameFromItsClient) {
  RawClient client = greeted();
  reorient_game game = game_of(false);
  game.datagram[18 + 70 + 10 + 6] = 12;  // the third player is sent off
  client.send(REORIENT_GAME, game);
  client.send(REORIENT_FRAME, standing_frame(1, 33.0, client.paint(90)));
  auto observation = observed();
  ASSERT_TRUE(observation && observation->external.referee);
  EXPECT_EQ(*observation->external.referee, (RefereeState{true, GameState::set, false, KickOff::ours}));
  game.datagram[1] = 'x';
  client.send(REORIENT_GAME, game);
  client.send(REORIENT_FRAME, standing_frame(2, 33.1, client.paint(90)));
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.referee);
}

TEST_F(CompanionTest, ReportsEachReasonToIgnoreADatagramOfTheGameOnce) {
  RawClient client = greeted();
  reorient_game game = game_of(true);
  game.datagram[4] = 21;
  for (std::uint32_t player : {3u, 4u}) {
    game.player = player;
    client.send(REORIENT_GAME, game);
  }
  game = game_of(true);
  game.player = 0xffff'ffffu;
  client.send(REORIENT_GAME, game);
  client.send_frame(33.0, 1);
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.referee);
  companion_->answer({});
  std::vector<std::string> notes;
  for (const RawClient::Heard& heard : client.hear()) {
    if (heard.kind == REORIENT_NOTE) notes.push_back(text_of(heard.as<reorient_note>().text));
  }
  const std::vector<std::string> expected{
      "GameController: datagram ignored: expected version 18, 19 or 20, found version 21",
      "GameController: datagram ignored: expected a team of 1 to 254 and a player of 1 to 20, found team 5 and player "
      "1000"};
  EXPECT_EQ(notes, expected);
  EXPECT_EQ(told_, expected) << "for the operator, too";
}

TEST_F(CompanionTest, AppliesAHalfTimeThatIsFirstReportedDuringPlay) {
  RawClient client = greeted();
  client.send(REORIENT_GAME, game_of(true));
  client.send_frame(33.0, 1);
  ASSERT_TRUE(observed());
  std::vector<std::byte> saved;
  ByteWriter{saved}(*companion_);
  // The companion was killed in the first half, and its client restarts in the second.
  companion_.reset();
  companion_.emplace(options());
  ByteReader{saved}(*companion_);
  begun_ = false;
  client = greeted(small_hello(8), true);
  reorient_game game = game_of(false);
  game.datagram[10] = 3;  // playing
  client.send(REORIENT_GAME, game);
  client.send_frame(1.0, 1);
  auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_TRUE(observation->external.half_time);
  game.datagram[10] = 4;  // finished
  client.send(REORIENT_GAME, game);
  client.send_frame(1.1, 2);
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.half_time) << "once";
}

TEST_F(CompanionTest, ConvertsAFrameToAnObservationAndAnswersIt) {
  RawClient client = greeted();
  reorient_frame frame = standing_frame(5, 33.0, client.paint(90));
  frame.has |= REORIENT_HAS_HEAD | REORIENT_HAS_TOLD_POSE | REORIENT_HAS_REFEREE | REORIENT_HAS_FOOT_LOAD;
  frame.head[0] = 0.5;
  frame.foot_load = 4.5;
  frame.told_pose[0] = -2.0;
  frame.told_deviation[0] = frame.told_deviation[1] = 0.1;
  frame.penalized = 1;
  frame.posture = REORIENT_FALLEN;
  client.send(REORIENT_FRAME, frame);
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_EQ(observation->time, 0.0);
  ASSERT_TRUE(observation->upper);
  EXPECT_EQ(observation->upper->image.at(10, 10).y, 90);
  EXPECT_EQ(observation->upper->camera.width, 64);
  EXPECT_GT(observation->upper->robot_from_camera.linear().col(0).y(), 0.4) << "the head is turned to the left";
  EXPECT_EQ(observation->body.foot_load, 4.5);
  EXPECT_EQ(observation->reported_posture, ReportedPosture::fallen);
  ASSERT_TRUE(observation->external.initial_pose);
  EXPECT_EQ(observation->external.initial_pose->pose.position.x(), -2.0);
  EXPECT_TRUE(observation->external.referee->penalized);
  EXPECT_FALSE(observation->belief) << "Reorient's localization is used";

  Answer answer;
  answer.belief = {Pose2(1.0, 2.0, 3.0), Eigen::Matrix3d::Identity(), true};
  answer.room = {0.25, 0.5, -3.0, true};
  answer.request.head = HeadRequest{{0.1, 0.2}, 1.5};
  answer.request.walk = {0.3, 0.0, -0.2};
  answer.reorientation = Reorientation::flip_pose;
  now_ += 0.002;
  companion_->answer(answer);
  const auto heard = client.answer();
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->number, 5u);
  EXPECT_EQ(heard->time, 33.0);
  EXPECT_NEAR(heard->took, 0.002, 1e-9);
  EXPECT_EQ(heard->has,
            std::uint32_t{REORIENT_ANSWER_POSE | REORIENT_ANSWER_HEAD | REORIENT_ANSWER_WALK | REORIENT_ANSWER_ROOM});
  EXPECT_EQ(heard->pose[1], 2.0);
  EXPECT_EQ(heard->covariance[3], 1.0);
  EXPECT_EQ(heard->evidence, -3.0);
  EXPECT_EQ(heard->head[2], 1.5);
  EXPECT_EQ(heard->walk[2], -0.2);
  EXPECT_EQ(heard->command, 0u) << "it is already carried out on the engine's belief";
}

TEST_F(CompanionTest, RepeatsACommandUntilItIsDone) {
  RawClient client = greeted(small_hello(7, REORIENT_OWN_LOCALIZATION));
  Answer flip, nothing;
  flip.reorientation = Reorientation::flip_pose;
  std::uint64_t number = 0;
  const auto exchange = [&](const Answer& answer, std::uint32_t done, std::uint64_t server = 77) {
    ++number;
    reorient_frame frame = standing_frame(number, 0.1 * static_cast<double>(number), client.paint(1));
    frame.done = done;
    frame.done_server = server;
    client.send(REORIENT_FRAME, frame);
    EXPECT_TRUE(observed());
    companion_->answer(answer);
    return client.answer().value_or(reorient_answer{});
  };
  EXPECT_EQ(exchange(nothing, 0).command, 0u);
  EXPECT_EQ(exchange(flip, 0).command, 1u);
  EXPECT_EQ(exchange(nothing, 0).command_kind, std::uint32_t{REORIENT_FLIP});
  EXPECT_EQ(exchange(flip, 0).command, 1u) << "a second flip would cancel the first";
  EXPECT_EQ(exchange(nothing, 1, 76).command, 1u) << "the command of another server was done";
  EXPECT_EQ(exchange(nothing, 1).command, 0u);
  EXPECT_EQ(exchange(flip, 1).command, 2u);
  Answer purge;
  purge.reorientation = Reorientation::purge_reflection;
  EXPECT_EQ(exchange(purge, 1).command_kind, std::uint32_t{REORIENT_FLIP})
      << "the purge is for the belief after the flip";
  Answer reset;
  reset.reorientation = Reorientation::reset_orientation;
  EXPECT_EQ(exchange(reset, 1).command, 3u) << "the newer command replaces the older one";
  EXPECT_EQ(exchange(nothing, 1).command_kind, std::uint32_t{REORIENT_RESET});
  // After the same process has connected again.
  client.end();
  static_cast<void>(observed());
  client = greeted(small_hello(7, REORIENT_OWN_LOCALIZATION));
  EXPECT_EQ(exchange(nothing, 1).command, 3u);
  // A restarted process has a new belief, which may not need the command.
  client.end();
  static_cast<void>(observed());
  client = greeted(small_hello(8, REORIENT_OWN_LOCALIZATION));
  EXPECT_EQ(exchange(nothing, 0).command, 0u);
}

TEST_F(CompanionTest, UsesTheNewestOfSeveralFramesAndLosesNoExternalInput) {
  RawClient client = greeted();
  for (std::uint64_t i = 1; i <= 3; ++i) {
    reorient_frame frame = standing_frame(i, static_cast<double>(i), client.paint(static_cast<std::uint8_t>(i)));
    if (i == 1) {
      frame.has |= REORIENT_HAS_TOLD_POSE;
      frame.told_deviation[0] = frame.told_deviation[1] = 0.1;
    }
    client.send(REORIENT_FRAME, frame);
  }
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_EQ(observation->upper->image.at(0, 0).y, 3);
  EXPECT_TRUE(observation->external.initial_pose);
  companion_->answer({});
  EXPECT_EQ(client.answer()->superseded, 2u);
  EXPECT_FALSE(observed()) << "no other frame waits";
}

reorient_frame frame_with_initial_pose(std::uint64_t number, double time, std::uint64_t sequence) {
  reorient_frame frame = standing_frame(number, time, sequence);
  frame.has |= REORIENT_HAS_TOLD_POSE;
  frame.told_pose[0] = -2.0;
  frame.told_pose[1] = 1.0;
  frame.told_deviation[0] = frame.told_deviation[1] = 0.1;
  return frame;
}

TEST_F(CompanionTest, DetectsHalfTimeAlsoIfFramesAreLost) {
  RawClient client = greeted();
  std::uint64_t number = 0;
  const auto frame_of = [&](std::uint32_t half) {
    ++number;
    reorient_frame frame = standing_frame(number, 0.1 * static_cast<double>(number), client.paint(1));
    frame.has |= half;
    return frame;
  };
  const auto changes_sides = [&](std::uint32_t half) {
    client.send(REORIENT_FRAME, frame_of(half));
    const auto observation = observed();
    EXPECT_TRUE(observation);
    return observation && observation->external.half_time;
  };
  EXPECT_FALSE(changes_sides(REORIENT_OTHER_HALF)) << "the value in the first frame of a process has no effect";
  EXPECT_FALSE(changes_sides(REORIENT_OTHER_HALF));
  EXPECT_TRUE(changes_sides(0));
  EXPECT_FALSE(changes_sides(0));
  std::vector<std::byte> before;
  ByteWriter{before}(*companion_);
  reorient_frame broken = frame_of(REORIENT_OTHER_HALF);
  broken.odometry[1] = std::numeric_limits<double>::quiet_NaN();
  client.send(REORIENT_FRAME, broken);
  EXPECT_FALSE(observed());
  const reorient_frame written_over = frame_of(REORIENT_OTHER_HALF);
  for (int i = 0; i < REORIENT_SLOTS; ++i) client.paint(2);
  client.send(REORIENT_FRAME, written_over);
  EXPECT_FALSE(observed());
  EXPECT_TRUE(changes_sides(REORIENT_OTHER_HALF)) << "two frames were lost, but not half-time";
  EXPECT_FALSE(changes_sides(REORIENT_OTHER_HALF));
  // A companion that was killed, and continues from the state before half-time.
  companion_.reset();
  companion_.emplace(options());
  ByteReader{before}(*companion_);
  begun_ = false;
  client = greeted(small_hello(), true);
  EXPECT_TRUE(changes_sides(REORIENT_OTHER_HALF));
  EXPECT_FALSE(changes_sides(REORIENT_OTHER_HALF)) << "once";
  client.end();
  static_cast<void>(observed());
  client = greeted(small_hello(8));
  EXPECT_FALSE(changes_sides(0)) << "another process has started in the present axes";
}

TEST_F(CompanionTest, UsesTheExternalInputsOfAnUnusableFrame) {
  RawClient client = greeted();
  std::vector<std::byte> bytes;
  reorient_frame frame = frame_with_initial_pose(1, 1.0, client.paint(1));
  frame.has |= REORIENT_HAS_REFEREE;
  frame.penalized = 1;
  frame.messages = 1;
  frame.images[0].age = -1.0;
  struct {
    reorient_frame frame;
    reorient_message word;
  } all{frame, {2, 5, "hello"}};
  client.send(REORIENT_FRAME, all);
  EXPECT_FALSE(observed());
  client.send_frame(1.1, 2);
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_TRUE(observation->external.initial_pose);
  EXPECT_TRUE(observation->external.referee && observation->external.referee->penalized);
  EXPECT_EQ(observation->external.messages.size(), 1u);
}

TEST_F(CompanionTest, MovesAnInitialPoseToTheFrameThatIsUsed) {
  RawClient client = greeted();
  client.send_frame(0.5, 1);
  ASSERT_TRUE(observed());
  client.send(REORIENT_FRAME, frame_with_initial_pose(2, 1.0, client.paint(1)));
  reorient_frame later = standing_frame(3, 1.5, client.paint(1));
  later.has |= REORIENT_OTHER_HALF;
  later.odometry[0] = 0.5;
  client.send(REORIENT_FRAME, later);
  auto observation = observed();
  ASSERT_TRUE(observation && observation->external.initial_pose);
  EXPECT_TRUE(observation->external.half_time);
  const Pose2 moved = observation->external.initial_pose->pose, expected = reflect(Pose2(-1.5, 1.0, 0.0));
  EXPECT_NEAR((moved.position - expected.position).norm(), 0.0, 1e-9) << moved.position.transpose();
  EXPECT_NEAR(angle_difference(moved.rotation, expected.rotation), 0.0, 1e-9);
  // The same if the GameController reports it.
  client.send(REORIENT_GAME, game_of(true));
  client.send_frame(2.0, 4);
  ASSERT_TRUE(observed());
  client.send(REORIENT_FRAME, frame_with_initial_pose(5, 2.5, client.paint(1)));
  client.send(REORIENT_GAME, game_of(false));
  client.send_frame(3.0, 6);
  observation = observed();
  ASSERT_TRUE(observation && observation->external.initial_pose);
  EXPECT_TRUE(observation->external.half_time);
  EXPECT_NEAR(observation->external.initial_pose->pose.position.x(), 2.0, 1e-9);
}

TEST_F(CompanionTest, IgnoresAnInitialPoseFarFromAnyField) {
  RawClient client = greeted();
  std::uint64_t number = 0;
  for (const double far : {101.0, -1e4, 1e308, std::numeric_limits<double>::quiet_NaN()}) {
    for (int axis = 0; axis < 2; ++axis) {
      ++number;
      reorient_frame frame = frame_with_initial_pose(number, static_cast<double>(number), client.paint(1));
      frame.told_pose[axis] = far;
      client.send(REORIENT_FRAME, frame);
      EXPECT_FALSE(observed()) << far;
    }
  }
  client.send_frame(100.0, ++number);
  const auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.initial_pose);
}

TEST_F(CompanionTest, RefusesUnknownValuesOfFieldsThatAreChoices) {
  const auto refusal = [this](auto&& change) {
    RawClient client = greeted();
    reorient_frame frame = standing_frame(1, now_, client.paint(1));
    reorient_sample sample{};
    sample.time = now_;
    change(frame, sample);
    client.send(REORIENT_SAMPLE, sample);
    client.send(REORIENT_FRAME, frame);
    now_ += 1.0;
    static_cast<void>(observed());
    std::string why = client.refusal();
    client.end();
    static_cast<void>(observed());
    return why;
  };
  using Frame = reorient_frame;
  using Sample = reorient_sample;
  EXPECT_EQ(refusal([](Frame&, Sample&) {}), "");
  EXPECT_EQ(refusal([](Frame& frame, Sample&) { frame.penalized = 2; }), "") << "unused without its bit";
  EXPECT_EQ(refusal([](Frame& frame, Sample&) {
              frame.has |= REORIENT_HAS_REFEREE;
              frame.penalized = 2;
            }),
            "frame: penalized is 2 (expected 0 to 1)");
  EXPECT_EQ(refusal([](Frame& frame, Sample&) { frame.has |= 1024; }),
            "frame: has is 1025, which contains unknown bits (expected a sum of bits of 1023)");
  EXPECT_EQ(refusal([](Frame& frame, Sample&) { frame.has = 0xffff'ffffu; }),
            "frame: has is 4294967295, which contains unknown bits (expected a sum of bits of 1023)");
  EXPECT_EQ(refusal([](Frame& frame, Sample&) { frame.images[1].present = 3; }),
            "frame: images: present is 3 (expected 0 to 2)");
  EXPECT_EQ(refusal([](Frame&, Sample& sample) { sample.has = 64; }),
            "sample: has is 64, which contains unknown bits (expected a sum of bits of 63)");
}

TEST_F(CompanionTest, ReportsClientsThatConnectLeaveOrAreRefused) {
  RawClient client = greeted();
  RawClient second(folder_.path() / "socket");
  second.introduce(small_hello(9));
  static_cast<void>(observed());
  static_cast<void>(observed());
  client.send(999, reorient_game{});
  static_cast<void>(observed());
  client = greeted();
  client.end();
  static_cast<void>(observed());
  const std::vector<std::string> expected{
      "client refused: another client is connected and sent data within the last 2 s",
      "client refused: unknown message type 999 (expected 1 to 7)", "client left",
      "client connected to the running engine", "client left"};
  EXPECT_EQ(told_, expected);
}

TEST_F(CompanionTest, SendsACommandOnlyAfterItsDecisionIsStored) {
  CompanionOptions options = this->options();
  options.stores_commands = true;
  companion_.reset();
  companion_.emplace(options);
  RawClient client = greeted(small_hello(7, REORIENT_OWN_LOCALIZATION));
  std::uint64_t number = 0;
  const auto command_after = [&](std::optional<Reorientation> decided) -> std::uint32_t {
    ++number;
    client.send_frame(static_cast<double>(number), number);
    EXPECT_TRUE(observed());
    Answer answer;
    answer.reorientation = decided;
    companion_->answer(answer);
    const std::optional<reorient_answer> heard = client.answer();
    EXPECT_TRUE(heard);
    return heard ? heard->command : 0;
  };
  EXPECT_EQ(command_after(std::nullopt), 0u);
  EXPECT_FALSE(companion_->unstored_command());
  EXPECT_EQ(command_after(Reorientation::flip_pose), 0u);
  EXPECT_EQ(command_after(std::nullopt), 0u) << "the answer does not wait, but the command does";
  ASSERT_EQ(companion_->unstored_command(), 1u);
  companion_->set_stored(7);
  EXPECT_EQ(command_after(std::nullopt), 0u) << "of another command";
  companion_->set_stored(1);
  EXPECT_FALSE(companion_->unstored_command());
  EXPECT_EQ(command_after(std::nullopt), 1u);
  EXPECT_EQ(command_after(Reorientation::reset_orientation), 0u) << "a new decision is stored first, too";
  EXPECT_EQ(companion_->unstored_command(), 2u);
  companion_->set_stored(1);
  EXPECT_EQ(command_after(std::nullopt), 0u);
  companion_->set_stored(2);
  EXPECT_EQ(command_after(std::nullopt), 2u);
}

TEST_F(CompanionTest, DropsAnInitialPoseIfTheClientsProcessRestarts) {
  RawClient client = greeted();
  const auto tell = [&] {
    reorient_frame frame = frame_with_initial_pose(1, 1.0, client.paint(1));
    frame.images[0].age = -1.0;
    client.send(REORIENT_FRAME, frame);
    static_cast<void>(observed());
    client.end();
    static_cast<void>(observed());
  };
  tell();
  client = greeted();
  client.send_frame(1.1, 2);
  auto observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_TRUE(observation->external.initial_pose) << "the same process has connected again";
  tell();
  client = greeted(small_hello(8));
  client.send_frame(1.1, 1);
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->external.initial_pose);
}

TEST_F(CompanionTest, WithdrawsCommandsFromARestartedClientEvenIfItsFirstFrameIsLost) {
  RawClient client = greeted(small_hello(7, REORIENT_OWN_LOCALIZATION));
  client.send_frame(1.0, 1);
  ASSERT_TRUE(observed());
  Answer flip;
  flip.reorientation = Reorientation::flip_pose;
  companion_->answer(flip);
  EXPECT_EQ(client.answer()->command, 1u);
  client.end();
  static_cast<void>(observed());
  client = greeted(small_hello(8, REORIENT_OWN_LOCALIZATION));
  const reorient_frame written_over = standing_frame(1, 1.0, client.paint(1));
  for (int i = 0; i < REORIENT_SLOTS; ++i) client.paint(2);
  client.send(REORIENT_FRAME, written_over);
  EXPECT_FALSE(observed());
  client.send_frame(1.1, 2);
  ASSERT_TRUE(observed());
  companion_->answer({});
  EXPECT_EQ(client.answer()->command, 0u);
}

/// A sample at this time of the client's clock.
reorient_sample sample_at(double time, double roll) {
  reorient_sample sample{};
  sample.time = time;
  sample.has = REORIENT_HAS_ATTITUDE;
  sample.attitude[0] = roll;
  return sample;
}

TEST_F(CompanionTest, StoresSamplesAfterAnImageForTheNextFrame) {
  RawClient client = greeted();
  std::vector<double> felt;
  constexpr int kPeriod = 3, kLate = 4;  // hundredths of a second
  for (int now = 0; now <= 30; ++now) {
    client.send(REORIENT_SAMPLE, sample_at(5.0 + 0.01 * now, 0.01 * now));
    if (now < kLate || (now - kLate) % kPeriod != 0) continue;
    client.send_frame(5.0 + 0.01 * (now - kLate), static_cast<std::uint64_t>(now));
    const auto observation = observed();
    ASSERT_TRUE(observation);
    if (now > kLate) {
      EXPECT_EQ(observation->body_samples.size(), std::size_t{kPeriod}) << "at " << now;
    }
    for (const BodySample& sample : observation->body_samples) {
      EXPECT_LE(sample.time, observation->time);
      EXPECT_NEAR(sample.torso.roll, sample.time, 1e-9) << "the engine's clock starts with the first image";
      felt.push_back(sample.time);
    }
  }
  EXPECT_EQ(felt.size(), 24u);
  EXPECT_TRUE(std::is_sorted(felt.begin(), felt.end()));
}

TEST_F(CompanionTest, DropsSamplesBeforeTheLastFrameOrOfAnotherClock) {
  RawClient client = greeted();
  client.send_frame(100.0, 1);
  ASSERT_TRUE(observed());
  for (const double time : {0.0, 1.7e9, 100.0, 100.03, 100.01, 102.5, 99.0, 1e300, 100.05, 100.2})
    client.send(REORIENT_SAMPLE, sample_at(time, 0.0));
  client.send_frame(100.1, 2);
  auto observation = observed();
  ASSERT_TRUE(observation);
  ASSERT_EQ(observation->body_samples.size(), 2u) << "after the last frame and in order";
  EXPECT_NEAR(observation->body_samples[0].time, 0.03, 1e-9);
  EXPECT_NEAR(observation->body_samples[1].time, 0.05, 1e-9);
  client.send_frame(103.0, 3);
  observation = observed();
  ASSERT_TRUE(observation);
  ASSERT_EQ(observation->body_samples.size(), 1u) << "a sample far in the future is dropped";
  EXPECT_NEAR(observation->body_samples[0].time, 0.2, 1e-9);
}

TEST_F(CompanionTest, DropsAnImageThatWasOverwritten) {
  RawClient client = greeted();
  const std::uint64_t sequence = client.paint(1);
  client.send(REORIENT_FRAME, standing_frame(1, 1.0, sequence));
  for (int i = 0; i < 3; ++i) client.paint(2);  // once through all slots
  EXPECT_FALSE(observed());
  EXPECT_EQ(companion_->counts().unusable, 1u);
  client.send_frame(1.1, 2);
  EXPECT_TRUE(observed()) << "later images are used";
}

TEST_F(CompanionTest, AcceptsAClockThatWasSetBackAfterASecond) {
  RawClient client = greeted();
  client.send_frame(100.0, 1);
  ASSERT_TRUE(observed());
  std::optional<Observation> observation;
  std::uint64_t tries = 0;
  while (!observation && ++tries < 60) {
    now_ += 1.0 / 30.0;
    client.send_frame(50.0 + static_cast<double>(tries) / 30.0, 1 + tries);
    observation = observed();
  }
  ASSERT_TRUE(observation);
  EXPECT_NEAR(static_cast<double>(tries), 30.0, 1.0);
  EXPECT_NEAR(observation->time, 1.0, 0.05) << "the engine's time has continued meanwhile";
}

TEST_F(CompanionTest, DropsFramesWithInvalidNumbers) {
  RawClient client = greeted();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t number = 0;
  const auto with = [&](auto spoil) {
    ++number;
    reorient_frame frame = standing_frame(number, static_cast<double>(number), client.paint(1));
    frame.has |= REORIENT_HAS_HEAD | REORIENT_HAS_BELIEF | REORIENT_HAS_ACCELERATION;
    spoil(frame);
    client.send(REORIENT_FRAME, frame);
    return observed().has_value();
  };
  EXPECT_TRUE(with([](reorient_frame&) {}));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.time = nan; }));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.odometry[2] = nan; }));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.head[0] = 1e30; }));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.belief[1] = nan; }));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.acceleration[1] = -std::numeric_limits<double>::infinity(); }));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.images[0].age = -1.0; }));
  EXPECT_FALSE(with([&](reorient_frame& frame) { frame.images[0].present = 2; }))
      << "a matrix of zeros is not a rotation";
  EXPECT_FALSE(with([&](reorient_frame& frame) {
    frame.has |= REORIENT_HAS_TOLD_POSE;
    frame.told_pose[0] = nan;
  }));
  EXPECT_TRUE(with([](reorient_frame&) {})) << "the client is still connected";
  EXPECT_EQ(companion_->counts().unusable, 8u);
}

TEST_F(CompanionTest, RefusesInvalidMessagesWithTheReason) {
  const auto refusal_of = [&](auto say) {
    RawClient client = greeted();
    say(client);
    static_cast<void>(observed());
    std::string why = client.refusal();
    EXPECT_FALSE(client.is_connected());
    return why;
  };
  const auto header = [](RawClient& client, std::uint32_t size, std::uint16_t kind, std::uint16_t version) {
    const reorient_header wrong{size, kind, version};
    client.send_bytes(std::as_bytes(std::span(&wrong, 1)));
  };
  EXPECT_NE(refusal_of([&](RawClient& client) { header(client, 8, REORIENT_FRAME, 1); }).find("found version 1"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](RawClient& client) {
              header(client, 0x80000000u, REORIENT_FRAME, REORIENT_VERSION_2);
            }).find("message of 2147483648 bytes (expected at most 65536)"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](RawClient& client) {
              client.send(9, reorient_memory{});
            }).find("unknown message type 9 (expected 1 to 7)"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](RawClient& client) {
              header(client, REORIENT_LONGEST_BODY, 9, REORIENT_VERSION_2);
              client.send_bytes(std::vector<std::byte>(REORIENT_LONGEST_BODY));
            }).find("unknown message type 9 (expected 1 to 7)"),
            std::string::npos)
      << "the longest message fits";
  EXPECT_NE(refusal_of([&](RawClient& client) {
              client.send(REORIENT_FRAME, reorient_memory{});
            }).find("frame: expected 512 bytes, found 8"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](RawClient& client) {
              client.send(REORIENT_HELLO, small_hello());
            }).find("second hello on one connection"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](RawClient& client) {
              reorient_frame frame = standing_frame(1, 1.0, 2);
              frame.images[0].slot = 3;
              client.send(REORIENT_FRAME, frame);
            }).find("images[0].slot is 3 (expected 0 to 2)"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](RawClient& client) {
              reorient_frame frame = standing_frame(1, 1.0, 0);
              frame.particles = 0xFFFFFFFFu;
              client.send(REORIENT_FRAME, frame);
            }).find("4294967295 particles (expected at most 2000)"),
            std::string::npos);
}

TEST_F(CompanionTest, RefusesMemoryThatCouldShrink) {
  const auto refusal_of = [&](const OwnedDescriptor& memory, reorient_memory layout) {
    RawClient client(folder_.path() / "socket");
    client.send(REORIENT_HELLO, small_hello());
    client.send(REORIENT_MEMORY, layout, memory.get());
    looks_ = 0;
    static_cast<void>(observed());
    return client.refusal();
  };
  const std::uint32_t slot = REORIENT_SLOT_HEADER + 64 * 64;
  EXPECT_NE(refusal_of(memory_of(3 * slot, false), {0, slot}).find("expected a memfd with F_SEAL_SHRINK"),
            std::string::npos);
  EXPECT_NE(refusal_of(memory_of(3 * slot - 1, true), {0, slot}).find("smaller than its slots"), std::string::npos);
  EXPECT_NE(refusal_of(memory_of(3 * slot, true), {0, slot - 64})
                .find("slot_size 4096 (expected a multiple of 64, at least 4160"),
            std::string::npos);
  EXPECT_NE(refusal_of(memory_of(3 * slot, true), {0, 0xFFFFFFC0u}).find("slot_size 4294967232 (expected"),
            std::string::npos);
  EXPECT_NE(refusal_of(memory_of(3 * slot, true), {1, slot}).find("the hello does not describe"), std::string::npos);
  EXPECT_NE(refusal_of(memory_of(3 * slot, true), {0xFFFFFFFFu, slot}).find("the hello does not describe"),
            std::string::npos);
  EXPECT_NE(refusal_of(OwnedDescriptor(), {0, slot}).find("without a file descriptor"), std::string::npos);
  EXPECT_NE(
      refusal_of(OwnedDescriptor(open("/dev/null", O_RDONLY)), {0, slot}).find("expected a memfd with F_SEAL_SHRINK"),
      std::string::npos);
  const OwnedDescriptor huge(memfd_create("huge", MFD_CLOEXEC | MFD_ALLOW_SEALING | MFD_HUGETLB));
  if (!huge) return;  // a kernel without such pages
  ASSERT_EQ(fcntl(huge.get(), F_ADD_SEALS, F_SEAL_SHRINK), 0);
  EXPECT_NE(refusal_of(huge, {0, slot}).find("of ordinary pages"), std::string::npos);
}

TEST_F(CompanionTest, ClosesAReceivedSocketWithoutWaitingForItsPeer) {
  RawClient client = greeted();
  const OwnedDescriptor network(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  linger patient{1, 60};
  ASSERT_EQ(setsockopt(network.get(), SOL_SOCKET, SO_LINGER, &patient, sizeof(patient)), 0);
  client.send(REORIENT_FRAME, standing_frame(1, 1.0, client.paint(1)), network.get());
  EXPECT_TRUE(observed());
  socklen_t size = sizeof(patient);
  ASSERT_EQ(getsockopt(network.get(), SOL_SOCKET, SO_LINGER, &patient, &size), 0);
  EXPECT_EQ(patient.l_onoff, 0);
}

TEST_F(CompanionTest, ReplacesAClientOnlyIfItIsSilent) {
  RawClient first = greeted();
  RawClient second(folder_.path() / "socket");
  static_cast<void>(observed());
  EXPECT_NE(second.refusal().find("another client is connected"), std::string::npos);
  now_ += 3.0;
  RawClient third(folder_.path() / "socket");
  third.introduce(small_hello(12));
  static_cast<void>(observed());
  third.send_frame(1.0, 1);
  EXPECT_TRUE(observed());
  static_cast<void>(first.hear());
  EXPECT_FALSE(first.is_connected());
}

TEST_F(CompanionTest, EndsIfTheNextClientIsAnotherRobot) {
  RawClient client = greeted();
  client.end();
  RawClient other(folder_.path() / "socket");
  reorient_hello hello = small_hello();
  hello.body.yaw_limit = 0.5;
  other.introduce(hello);
  EXPECT_FALSE(observed());
  EXPECT_FALSE(companion_->has_other_robot()) << "it has sent only a hello so far";
  EXPECT_TRUE(other.hear().empty());
  other.send_frame(1.0, 1);
  EXPECT_FALSE(observed());
  ASSERT_TRUE(companion_->has_other_robot());
  companion_->begin(*companion_->wait_for_handshake(), false, 3);
  EXPECT_TRUE(observed()) << "the frame waited for its engine";
}

TEST_F(CompanionTest, ContinuesWithItsRobotAfterAnotherOneThatSentOnlyAHello) {
  RawClient client = greeted();
  client.end();
  {
    RawClient other(folder_.path() / "socket");
    reorient_hello hello = small_hello(9);
    hello.body.yaw_limit = 0.5;
    other.introduce(hello);
    static_cast<void>(observed());
  }
  static_cast<void>(observed());
  client = greeted();
  client.send_frame(1.0, 1);
  EXPECT_TRUE(observed());
  EXPECT_FALSE(companion_->has_other_robot());
}

TEST_F(CompanionTest, SendsStatesAtFirstAndWhenTheyChange) {
  RawClient client = greeted();
  const auto states = [&] {
    companion_->answer({});
    std::vector<std::string> texts;
    for (const RawClient::Heard& one : client.hear()) {
      if (one.kind == REORIENT_STATE) texts.push_back(text_of(one.as<reorient_state>().state));
    }
    return texts;
  };
  companion_->tell_state("orientation", "watching");
  EXPECT_EQ(states(), std::vector<std::string>{"watching"});
  companion_->tell_state("orientation", "watching");
  EXPECT_TRUE(states().empty());
  companion_->tell_state("orientation", std::string(500, 'x'));
  EXPECT_EQ(states().at(0).size(), 191u);
  client.end();
  static_cast<void>(observed());
  client = greeted();
  EXPECT_EQ(states().size(), 1u) << "a new client gets all states";
}

TEST_F(CompanionTest, SendsMessagesToTheTeamOnceAndOnlyWhileAClientIsConnected) {
  RawClient client = greeted();
  const auto words = [&] {
    std::vector<std::string> texts;
    for (const RawClient::Heard& one : client.hear()) {
      if (one.kind == REORIENT_NOTE && one.as<reorient_note>().kind == REORIENT_NOTE_MESSAGE)
        texts.push_back(text_of(one.as<reorient_note>().text));
    }
    return texts;
  };
  Answer answer;
  answer.messages = {"I flipped", std::string(240, 'x')};
  for (int i = 0; i < 200; ++i) companion_->tell_note(NoteKind::log, "a flood");
  companion_->answer(answer);
  EXPECT_EQ(words(), answer.messages);
  companion_->answer({});
  EXPECT_TRUE(words().empty());
  client.end();
  static_cast<void>(observed());
  companion_->answer(answer);
  client = greeted();
  companion_->answer({});
  EXPECT_TRUE(words().empty()) << "it was sent before this client connected";
}

TEST_F(CompanionTest, ContinuesWithoutAClientThatDoesNotRead) {
  RawClient client = greeted();
  for (int i = 0; i < 5000; ++i) companion_->answer({});
  EXPECT_GT(companion_->counts().unanswered, 1000u);
  client.send_frame(1.0, 1);
  EXPECT_TRUE(observed());
  const std::size_t heard = client.hear().size();
  EXPECT_GT(heard, 100u) << "all messages are whole";
  companion_->answer({});
  EXPECT_TRUE(client.answer());
}

TEST_F(CompanionTest, AllowsOnlyItsUserToConnect) {
  struct stat status {};
  ASSERT_EQ(stat((folder_.path() / "socket").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(CompanionTest, ReportsWhyItCannotListen) {
  const auto complaint = [&](const std::filesystem::path& path) -> std::string {
    CompanionOptions options = this->options();
    options.socket = path;
    try {
      Companion companion(options);
      return {};
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  EXPECT_NE(complaint(folder_.path() / "socket").find("another companion listens there"), std::string::npos);
  EXPECT_NE(complaint(folder_.write("file", "x")).find("expected a socket or no file"), std::string::npos);
  EXPECT_NE(complaint(folder_.path() / std::string(200, 'x')).find("(expected 1 to 107)"), std::string::npos);
  EXPECT_NE(complaint(folder_.path() / "gone" / "socket").find("No such file"), std::string::npos);
  companion_.reset();
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "socket"));
}

TEST_F(CompanionTest, OnlyOneListensIfManyStartAtOnce) {
  const std::filesystem::path path = folder_.path() / "contested";
  for (int round = 0; round < 20; ++round) {
    // The socket of a process that was killed.
    const OwnedDescriptor left(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.string().copy(address.sun_path, sizeof(address.sun_path) - 1);
    ASSERT_EQ(bind(left.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);

    std::array<std::unique_ptr<Connection>, 4> all;  // the number of connections that may wait to be accepted
    std::vector<std::thread> threads;
    threads.reserve(all.size());
    for (std::unique_ptr<Connection>& one : all) {
      threads.emplace_back([&one, &path] {
        try {
          one = std::make_unique<Connection>(path, [] { return 0.0; });
        } catch (const std::runtime_error&) {  // another companion was faster
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const auto& one) { return one != nullptr; }), 1);
    EXPECT_TRUE(RawClient(path).is_connected());
    for (std::unique_ptr<Connection>& one : all) one.reset();
    ASSERT_FALSE(std::filesystem::exists(path));
  }
}

TEST_F(CompanionTest, DoesNotRemoveTheSocketOfAnotherProcess) {
  std::filesystem::remove(folder_.path() / "socket");
  const Companion other(options());
  companion_.reset();
  EXPECT_TRUE(RawClient(folder_.path() / "socket").is_connected());
}

TEST_F(CompanionTest, RemovesOnlyAStreamSocketThatNoProcessUses) {
  const std::filesystem::path path = folder_.path() / "other";
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string text = path.string();
  std::copy(text.begin(), text.end(), address.sun_path);
  CompanionOptions options = this->options();
  options.socket = path;
  for (const int type : {SOCK_STREAM, SOCK_DGRAM, SOCK_SEQPACKET}) {
    SCOPED_TRACE(type);
    OwnedDescriptor other(socket(AF_UNIX, type | SOCK_CLOEXEC, 0));
    ASSERT_EQ(bind(other.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    ASSERT_EQ(listen(other.get(), 1), type == SOCK_DGRAM ? -1 : 0);
    struct stat before {
    }, after{};
    ASSERT_EQ(lstat(path.c_str(), &before), 0);
    try {
      const Companion companion(options);
      FAIL() << "it listens at the socket of another program";
    } catch (const std::runtime_error& error) {
      const char* const why = type == SOCK_STREAM ? "another companion listens there" : "a socket of another program";
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
    ASSERT_EQ(lstat(path.c_str(), &after), 0) << "it was removed";
    EXPECT_EQ(after.st_ino, before.st_ino);
    other = OwnedDescriptor();
    { const Companion companion(options); }  // its process has ended
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  if (geteuid() != 0) return;
  // Only root can create a socket of another user.
  {
    const OwnedDescriptor other(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    ASSERT_EQ(bind(other.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  ASSERT_EQ(lchown(path.c_str(), 12345, 12345), 0);
  EXPECT_THROW(Companion{options}, std::runtime_error);
}

TEST_F(CompanionTest, ReportsWhyAFrameIsUnusableButNotForEachFrame) {
  RawClient client = greeted();
  std::uint64_t number = 100;
  const auto notes_after = [&](const auto& spoil) {
    now_ += 0.033;
    ++number;
    reorient_frame frame = standing_frame(number, 0.1 * static_cast<double>(number), client.paint(1));
    spoil(frame);
    client.send(REORIENT_FRAME, frame);
    EXPECT_FALSE(observed());
    std::vector<std::string> notes;
    for (const RawClient::Heard& one : client.hear()) {
      if (one.kind == REORIENT_NOTE) notes.emplace_back(text_of(one.as<reorient_note>().text));
    }
    return notes;
  };
  const auto has_young_image = [](reorient_frame& frame) { frame.images[0].age = -0.005; };
  const std::vector<std::string> first = notes_after(has_young_image);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_NE(first[0].find("frame 101 dropped: images[0].age is -0.005000 s (expected 0 to 1"), std::string::npos)
      << first[0];
  EXPECT_TRUE(notes_after(has_young_image).empty()) << "a client that sends one such frame sends many";
  now_ += 1.0;
  const std::vector<std::string> later = notes_after([](reorient_frame& frame) {
    frame.has |= REORIENT_HAS_TOLD_POSE;
    frame.told_deviation[0] = 0.0;
  });
  ASSERT_EQ(later.size(), 1u);
  EXPECT_NE(later[0].find("invalid told_pose or told_deviation (expected -100 to 100 m, "), std::string::npos)
      << later[0];
}

TEST_F(CompanionTest, RefusesAClientWithoutAnEngineWithTheReasonAndServesTheNext) {
  RawClient client(folder_.path() / "socket");
  client.introduce(small_hello());
  ASSERT_NE(companion_->wait_for_handshake(), nullptr);
  companion_->refuse("its model is of another wall");
  EXPECT_EQ(client.refusal(), "its model is of another wall");
  RawClient next = greeted();
  next.send_frame(1.0, 1);
  EXPECT_TRUE(observed());
}

}  // namespace
}  // namespace reorient
