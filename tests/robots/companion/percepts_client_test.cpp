// SPDX-License-Identifier: MIT
// Percepts of a client's own detector: what the engine receives, what is dropped, and what is refused.
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "robots/companion/companion.h"
#include "robots/companion/percept_message.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ExternalPercept percept(PerceptType type, PerceptSpace space, std::array<double, 4> at) {
  return {.type = type, .space = space, .at = at, .direction = 0.5};
}

TEST(ExternalPercept, WithAnInvalidNumberHasAMistakeThatNamesIt) {
  const auto mistake = [](auto change, PerceptType type = PerceptType::ball,
                          PerceptSpace space = PerceptSpace::upper_image) {
    ExternalPercept one = percept(type, space, {10.0, 20.0, 5.0, 7.0});
    change(one);
    return mistake_in(one);
  };
  const auto nothing = [](ExternalPercept&) {};
  EXPECT_EQ(mistake(nothing), "");
  EXPECT_EQ(mistake([](auto& one) { one.confidence = kNaN; }), "ball: confidence: expected 0 to 1, found nan");
  EXPECT_EQ(mistake([](auto& one) { one.confidence = 1.5; }), "ball: confidence: expected 0 to 1, found 1.500000");
  EXPECT_EQ(mistake([](auto& one) { one.at[1] = kNaN; }), "ball: at: expected -10000 to 10000 pixels, found nan");
  EXPECT_EQ(mistake([](auto& one) { one.at[2] = 0.0; }), "ball: radius: expected more than 0 pixels");
  EXPECT_EQ(mistake([](auto& one) { one.at[3] = kNaN; }), "") << "a ball does not use this number";
  EXPECT_EQ(mistake([](auto& one) { one.direction = 1e9; }),
            "ball: direction: expected -10 to 10 rad, found 1000000000.000000");
  for (const std::array<double, 3>& bad :
       {std::array{0.0, 0.0, 1.0}, std::array{1.0, 2.0, 1.0}, std::array{1.0, kNaN, 1.0}, std::array{-1.0, 0.0, -1.0},
        std::array{1e9, 0.0, 1.0}})
    EXPECT_EQ(mistake([&](auto& one) { one.covariance = bad; }),
              "ball: covariance: expected a positive definite matrix of at most 1e6");
  EXPECT_EQ(mistake(nothing, PerceptType::robot), "robot: at: expected left <= right and top <= bottom");
  EXPECT_EQ(mistake(nothing, PerceptType::goal_post), "");
  EXPECT_EQ(mistake([](auto& one) { one.at[3] = 30.0; }, PerceptType::goal_post),
            "goal post: at: expected the top above the base");
  EXPECT_EQ(mistake([](auto& one) { one.direction.reset(); }, PerceptType::line_point, PerceptSpace::ground),
            "line point: direction: missing");
  EXPECT_EQ(mistake([](auto& one) { one.at[0] = 1e3; }, PerceptType::person, PerceptSpace::ground),
            "person: at: expected -100 to 100 m, found 1000.000000");
  EXPECT_EQ(mistake([](auto& one) { one.at[3] = -1.0; }, PerceptType::person, PerceptSpace::ground),
            "person: width, height: expected 0 to 10 m");
}

reorient_percept sent_ball() {
  reorient_percept ball{};
  ball.what = REORIENT_PERCEPT_BALL;
  ball.confidence = 0.75f;
  ball.at[0] = 1.5f;
  ball.at[1] = -0.5f;
  return ball;
}

void append(const auto& structure, std::vector<std::byte>& bytes) {
  const auto* const begin = reinterpret_cast<const std::byte*>(&structure);
  bytes.insert(bytes.end(), begin, begin + sizeof(structure));
}

/// The bytes after a frame's messages.
std::vector<std::byte> block_of(const std::vector<reorient_percept>& percepts) {
  std::vector<std::byte> bytes;
  append(reorient_percepts{static_cast<std::uint32_t>(percepts.size()), 0}, bytes);
  for (const reorient_percept& one : percepts) append(one, bytes);
  return bytes;
}

RC_GTEST_PROP(PerceptMessageProperty, ContainsOnlyValidPerceptsForAnyBytes, ()) {
  std::vector<reorient_percept> sent(static_cast<std::size_t>(*rc::gen::inRange(0, 5)));
  for (reorient_percept& one : sent) {
    std::vector<std::uint32_t> words =
        *rc::gen::container<std::vector<std::uint32_t>>(12, rc::gen::arbitrary<std::uint32_t>());
    words[0] %= 11;
    words[1] %= 3;
    words[2] %= 8;
    std::memcpy(&one, words.data(), sizeof(one));
  }
  const std::vector<std::byte> bytes = block_of(sent);
  std::span<const std::byte> left = bytes;
  PerceptMessage message;
  read_percepts(left, message);
  RC_ASSERT(left.empty());
  RC_ASSERT(message.list.size() + message.dropped == sent.size());
  for (const ExternalPercept& one : message.list) RC_ASSERT(mistake_in(one).empty());
}

class PerceptsClient : public testing::Test {
 protected:
  PerceptsClient() {
    companion_.emplace(CompanionOptions{folder_.path() / "socket", no_known_robots(), 77, [this] { return now_; },
                                        [this] { return ++looks_ > 3; }, 0.0,
                                        [this](const std::string& line) { lines_.push_back(line); }});
  }

  static std::vector<std::byte> hello(const std::vector<std::byte>& after_lenses) {
    std::vector<std::byte> bytes;
    const reorient_hello hello = small_hello();
    const reorient_lens lenses[2]{};
    append(reorient_header{static_cast<std::uint32_t>(sizeof(hello) + sizeof(lenses) + after_lenses.size()),
                           REORIENT_HELLO, REORIENT_VERSION_2},
           bytes);
    append(hello, bytes);
    append(lenses, bytes);
    bytes.insert(bytes.end(), after_lenses.begin(), after_lenses.end());
    return bytes;
  }
  static std::vector<std::byte> detector(std::uint32_t use) {
    std::vector<std::byte> bytes;
    append(reorient_interface{}, bytes);
    append(reorient_detector{use, 0}, bytes);
    return bytes;
  }
  /// Without a detector: `use` 0.
  RawClient greeted(std::uint32_t use) {
    RawClient client(folder_.path() / "socket");
    use == 0 ? client.introduce(small_hello()) : client.introduce(hello(detector(use)));
    looks_ = 0;
    const Handshake* const handshake = companion_->wait_for_handshake();
    EXPECT_NE(handshake, nullptr);
    if (handshake != nullptr && !begun_) companion_->begin(*handshake, false, 3);
    begun_ = true;
    static_cast<void>(observed());
    return client;
  }
  void send_frame(RawClient& client, const std::vector<std::byte>& after) {
    now_ += 0.1;
    const reorient_frame frame = standing_frame(++number_, now_, client.paint(7));
    std::vector<std::byte> bytes;
    append(
        reorient_header{static_cast<std::uint32_t>(sizeof(frame) + after.size()), REORIENT_FRAME, REORIENT_VERSION_2},
        bytes);
    append(frame, bytes);
    bytes.insert(bytes.end(), after.begin(), after.end());
    client.send_bytes(bytes);
  }
  std::optional<Observation> observed() {
    looks_ = 0;
    Observation observation;
    if (!companion_->observe(observation)) return std::nullopt;
    return observation;
  }

  TemporaryFolder folder_;
  double now_ = 100.0;
  std::uint64_t number_ = 0;
  int looks_ = 0;
  bool begun_ = false;
  std::vector<std::string> lines_;
  std::optional<Companion> companion_;
};

TEST_F(PerceptsClient, SendsThemWithAFrame) {
  RawClient client = greeted(REORIENT_PERCEPTS_WITH);
  reorient_percept goal{};
  goal.what = REORIENT_PERCEPT_GOAL_POST;
  goal.space = REORIENT_IN_UPPER_IMAGE;
  goal.has = REORIENT_PERCEPT_BASE_HIDDEN | REORIENT_PERCEPT_DIRECTION | REORIENT_PERCEPT_COVARIANCE;
  goal.confidence = 1.0f;
  goal.at[1] = 40.0f;
  goal.direction = 0.25f;
  goal.covariance[0] = goal.covariance[2] = 2.0f;
  send_frame(client, block_of({sent_ball(), goal}));
  auto observation = observed();
  ASSERT_TRUE(observation && observation->percepts) << client.refusal();
  EXPECT_FALSE(observation->percepts->replaces_vision);
  ASSERT_EQ(observation->percepts->list.size(), 2u);
  const ExternalPercept& ball = observation->percepts->list[0];
  EXPECT_EQ(ball.type, PerceptType::ball);
  EXPECT_EQ(ball.space, PerceptSpace::ground);
  EXPECT_EQ(ball.confidence, 0.75);
  EXPECT_EQ(ball.at[0], 1.5);
  EXPECT_FALSE(ball.direction || ball.covariance || ball.base_hidden);
  const ExternalPercept& post = observation->percepts->list[1];
  EXPECT_TRUE(post.base_hidden);
  EXPECT_EQ(post.direction, 0.25);
  EXPECT_EQ(post.covariance, (std::array{2.0, 0.0, 2.0}));
  send_frame(client, block_of({}));
  observation = observed();
  ASSERT_TRUE(observation && observation->percepts) << "the detector found nothing";
  EXPECT_TRUE(observation->percepts->list.empty());
  send_frame(client, {});
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_FALSE(observation->percepts) << "the detector has not looked at this frame";
}

TEST_F(PerceptsClient, ChoosesWhetherTheyReplaceTheFieldVision) {
  RawClient client = greeted(REORIENT_PERCEPTS_INSTEAD);
  send_frame(client, block_of({sent_ball()}));
  const auto observation = observed();
  ASSERT_TRUE(observation && observation->percepts);
  EXPECT_TRUE(observation->percepts->replaces_vision);
}

TEST_F(PerceptsClient, SendsNoneWithoutTheBlockOfTheHello) {
  RawClient client = greeted(0);
  send_frame(client, block_of({sent_ball()}));
  EXPECT_FALSE(observed());
  EXPECT_EQ(client.refusal(), "frame: 56 bytes more than its particles and messages need");
}

TEST_F(PerceptsClient, LosesInvalidOnesAndLearnsItOnce) {
  RawClient client = greeted(REORIENT_PERCEPTS_WITH);
  reorient_percept bad = sent_ball();
  bad.at[1] = std::numeric_limits<float>::infinity();
  send_frame(client, block_of({sent_ball(), bad, bad}));
  auto observation = observed();
  ASSERT_TRUE(observation && observation->percepts);
  EXPECT_EQ(observation->percepts->list.size(), 1u);
  companion_->answer({});
  const std::string expected =
      "frame 1: 2 of its percepts dropped: percepts[1]: ball: at: expected -100 to 100 m, found inf";
  std::string note;
  for (const RawClient::Heard& heard : client.hear()) {
    if (heard.kind == REORIENT_NOTE) note = text_of(heard.as<reorient_note>().text);
  }
  EXPECT_EQ(note, expected);
  send_frame(client, block_of({bad}));
  ASSERT_TRUE(observed());
  companion_->answer({});
  for (const RawClient::Heard& heard : client.hear()) EXPECT_NE(heard.kind, REORIENT_NOTE);
  EXPECT_EQ(companion_->counts().percepts, 3u);
  EXPECT_EQ(std::count(lines_.begin(), lines_.end(), expected), 1);
}

TEST_F(PerceptsClient, IsRefusedForWhatTheProtocolDoesNotKnow) {
  const auto refusal = [&](auto change, std::size_t cut = 0) {
    RawClient client = greeted(REORIENT_PERCEPTS_WITH);
    std::vector<reorient_percept> list{sent_ball()};
    change(list);
    std::vector<std::byte> bytes = block_of(list);
    bytes.resize(bytes.size() - cut);
    send_frame(client, bytes);
    EXPECT_FALSE(observed());
    return client.refusal();
  };
  EXPECT_EQ(refusal([](auto& list) { list[0].what = 11; }), "frame: percepts[0].what is 11 (expected 0 to 10)");
  EXPECT_EQ(refusal([](auto& list) { list[0].space = 3; }), "frame: percepts[0].space is 3 (expected 0 to 2)");
  EXPECT_EQ(refusal([](auto& list) { list[0].has = 8; }),
            "frame: percepts[0].has is 8, which contains unknown bits (expected a sum of bits of 7)");
  EXPECT_EQ(refusal([](auto& list) { list.resize(257); }), "frame: 257 percepts (expected at most 256)");
  EXPECT_EQ(refusal([](auto&) {}, 1), "frame: percept: expected 48 bytes, found 47");
  EXPECT_EQ(refusal([](auto&) {}, 50), "frame: percepts: expected 8 bytes, found 6");
}

TEST_F(PerceptsClient, WithAWrongBlockInItsHelloIsRefused) {
  const auto refusal = [&](const std::vector<std::byte>& after_lenses) {
    RawClient client(folder_.path() / "socket");
    client.introduce(hello(after_lenses));
    looks_ = 0;
    static_cast<void>(companion_->wait_for_handshake());
    return client.refusal();
  };
  EXPECT_EQ(refusal(detector(3)),
            "hello: detector: use is 3 (expected 1, with Reorient's field vision, or 2, instead of it)");
  std::vector<std::byte> short_block = detector(1);
  short_block.pop_back();
  EXPECT_EQ(refusal(short_block), "hello: interface: expected a text of 1 to 32768 bytes, found 0");
  std::vector<std::byte> long_block = detector(1);
  long_block.push_back({});
  EXPECT_EQ(refusal(long_block), "hello: interface: expected a text of 1 to 32768 bytes, found 0");
}

}  // namespace
}  // namespace reorient
