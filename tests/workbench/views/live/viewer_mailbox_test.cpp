// SPDX-License-Identifier: MIT
// The messages that wait for a viewer: bounded, images are dropped first, answers never without ending the connection.
#include "workbench/views/live/server/viewer_mailbox.h"

#include <cstring>
#include <future>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/waiting.h"

namespace reorient::live {
namespace {

constexpr ViewerMailbox::Limits kSmall{
    .data_bytes = 100, .data_messages = 8, .control_bytes = 100, .control_messages = 4};

Outgoing message(const std::string& text) {
  return {WebSocketType::binary, {}, std::make_shared<const std::string>(text)};
}

std::string text_of(const Outgoing& message) {
  return std::string(reinterpret_cast<const char*>(message.own.data()), message.own.size()) +
         (message.shared ? *message.shared : "");
}

/// What is taken until the mailbox is closed, without the close frame.
std::vector<std::string> drain(ViewerMailbox& mailbox) {
  mailbox.add_control("end");
  std::vector<std::string> all;
  bool ended = false;
  while (!ended) {
    all.push_back(text_of(*mailbox.wait()));
    ended = all.back() == "end";
  }
  all.pop_back();  // control comes first, so the data follows
  return all;
}

std::string padded(const std::string& text) { return text + std::string(40 - text.size(), '.'); }

TEST(ViewerMailbox, GivesControlBeforeDataAndEachInItsOrder) {
  ViewerMailbox mailbox(kSmall);
  mailbox.add_data(message("d1"), Importance::data);
  mailbox.add_data(message("d2"), Importance::image);
  mailbox.add_control("c1");
  mailbox.add_control("c2");
  EXPECT_EQ(drain(mailbox), (std::vector<std::string>{"c1", "c2"}));
  EXPECT_EQ(text_of(*mailbox.wait()), "d1");
  EXPECT_EQ(text_of(*mailbox.wait()), "d2");
}

TEST(ViewerMailbox, DropsTheOldestImagesFirst) {
  ViewerMailbox mailbox(kSmall);
  mailbox.add_data(message(padded("data")), Importance::data);
  mailbox.add_data(message(padded("old image")), Importance::image);
  mailbox.add_data(message(padded("new image")), Importance::image);
  EXPECT_EQ(mailbox.dropped(), 1u);
  mailbox.add_data(message(padded("new data")), Importance::data);
  EXPECT_EQ(mailbox.dropped(), 2u);
  EXPECT_NE(text_of(*mailbox.wait()).find("Send buffer limit reached"), std::string::npos);
  EXPECT_EQ(text_of(*mailbox.wait()), padded("data"));
  EXPECT_EQ(text_of(*mailbox.wait()), padded("new data"));
}

TEST(ViewerMailbox, DropsOldDataBeforeLastingMessages) {
  ViewerMailbox mailbox(kSmall);
  mailbox.add_data(message(padded("lasting")), Importance::lasting);
  mailbox.add_data(message(padded("old")), Importance::data);
  mailbox.add_data(message(padded("new")), Importance::data);
  mailbox.wait();  // the status
  EXPECT_EQ(text_of(*mailbox.wait()), padded("lasting"));
  EXPECT_EQ(text_of(*mailbox.wait()), padded("new"));
  EXPECT_EQ(mailbox.dropped(), 1u);
}

TEST(ViewerMailbox, NeverExceedsItsLimits) {
  ViewerMailbox mailbox(kSmall);
  for (int i = 0; i < 1000; ++i) mailbox.add_data(message("x"), Importance::lasting);
  mailbox.add_data(message(std::string(101, 'x')), Importance::data);
  EXPECT_GE(mailbox.dropped(), 992u);
}

TEST(ViewerMailbox, ReportsDropsWithTheTextThatViewersKnow) {
  ViewerMailbox mailbox(kSmall);
  for (int i = 0; i < 20; ++i) mailbox.add_data(message("x"), Importance::data);
  const auto status = nlohmann::json::parse(text_of(*mailbox.wait()));
  EXPECT_EQ(status["op"], "status");
  EXPECT_EQ(status["level"], 1);
  EXPECT_EQ(status["message"], "Send buffer limit reached");
  EXPECT_EQ(status["id"], "dropped");
}

TEST(ViewerMailbox, DisconnectsAViewerThatDoesNotReadAnswers) {
  ViewerMailbox mailbox(kSmall);
  mailbox.add_data(message("data"), Importance::data);
  for (int i = 0; i < 10; ++i) mailbox.add_control("c");
  const auto close = mailbox.wait();
  ASSERT_TRUE(close);
  EXPECT_EQ(close->type, WebSocketType::close);
  EXPECT_NE(text_of(*close).find("does not read"), std::string::npos);
  EXPECT_FALSE(mailbox.wait());
}

TEST(ViewerMailbox, SendsWhatWaitsBeforeItCloses) {
  ViewerMailbox mailbox(kSmall);
  mailbox.add_control("last words");
  mailbox.close(kNormalClose, "the end");
  mailbox.close(kProtocolError, "not this");
  mailbox.add_control("too late");
  EXPECT_EQ(text_of(*mailbox.wait()), "last words");
  EXPECT_NE(text_of(*mailbox.wait()).find("the end"), std::string::npos);
  EXPECT_FALSE(mailbox.wait());
}

TEST(ViewerMailbox, IsGivenUpSomeTimeAfterItWasClosed) {
  ViewerMailbox mailbox(kSmall);
  EXPECT_FALSE(mailbox.is_given_up());
  mailbox.close(kNormalClose, "");
  EXPECT_TRUE(await([&] { return mailbox.is_given_up(); }));
}

FrameMessage frame_message(std::uint32_t subscription, const std::string& text) {
  return {subscription, std::make_shared<const std::string>(text), Importance::data, std::nullopt, false};
}

/// Takes messages, and answers pings at once or not at all.
struct TestedReader {
  ViewerMailbox& mailbox;
  bool answers = false;
  std::vector<std::byte> ping{};  // the last one
  int pings = 0;
  std::vector<std::uint64_t> times{};  // ns, that were sent before frames

  /// The next message that is neither a ping nor a time.
  std::string take() {
    while (true) {
      const auto message = mailbox.wait();
      if (!message) return "closed";
      if (is_time(*message)) continue;
      if (message->type != WebSocketType::ping) return message->shared ? *message->shared : text_of(*message);
      ping = message->own;
      ++pings;
      if (answers) mailbox.receive_pong(ping);
    }
  }
  bool is_time(const Outgoing& message) {
    constexpr std::size_t kSize = 1 + sizeof(std::uint64_t);
    if (message.type != WebSocketType::binary || message.own.size() != kSize || message.own[0] != std::byte{2})
      return false;
    std::memcpy(&times.emplace_back(), &message.own[1], sizeof times.back());
    return true;
  }
  void begin_to_answer() {
    answers = true;
    mailbox.receive_pong(ping);
  }
};

TEST(ViewerMailbox, SendsEveryFrameToAViewerThatDoesNotAnswerPings) {
  ViewerMailbox mailbox;
  mailbox.measure(true);
  for (std::uint64_t i = 0; i < 100; ++i) mailbox.add_frame(i, {frame_message(1, "frame " + std::to_string(i))});
  TestedReader reader{mailbox};
  for (int i = 0; i < 100; ++i) EXPECT_EQ(reader.take(), "frame " + std::to_string(i));
  EXPECT_EQ(reader.pings, 1);
  ASSERT_EQ(reader.times.size(), 100u);
  EXPECT_EQ(reader.times.back(), 99u);
  EXPECT_EQ(mailbox.left_out().frames, 0u);
}

/// A viewer that has stopped to answer pings, so that frames wait.
class SlowViewer : public ::testing::Test {
 protected:
  SlowViewer() {
    mailbox.measure(true);
    reader.answers = true;
    mailbox.add_control("begin");
    EXPECT_EQ(reader.take(), "begin");
    reader.answers = false;
    EXPECT_TRUE(await([&] {
      add_frame();
      mailbox.add_control("next");
      while (reader.take() != "next") {
      }
      return mailbox.left_out().frames > 1;
    }));
  }
  /// With a lasting message in every second frame.
  void add_frame() {
    std::vector<FrameMessage> messages{frame_message(1, "frame " + std::to_string(++time))};
    if (time % 2 == 0) {
      messages.push_back(frame_message(2, "lasting " + std::to_string(time)));
      messages.back().waits = true;
    }
    mailbox.add_frame(time, std::move(messages));
  }
  /// All messages until this one.
  std::vector<std::string> take_until(const std::string& last) {
    std::vector<std::string> all;
    while (all.empty() || (all.back() != last && all.back() != "closed")) all.push_back(reader.take());
    return all;
  }
  ViewerMailbox mailbox;
  TestedReader reader{mailbox};
  std::uint64_t time = 0;
};

TEST_F(SlowViewer, ReceivesTheNewestFrameAndTheNewestLastingMessageWhenItAnswers) {
  for (int i = 0; i < 5; ++i) add_frame();
  mailbox.add_data(message("an event"), Importance::lasting);
  take_until("an event");
  reader.begin_to_answer();
  const auto rest = take_until("lasting " + std::to_string(time - time % 2));
  EXPECT_EQ(rest.front(), "frame " + std::to_string(time));
  EXPECT_GE(mailbox.left_out().frames, 4u);
}

TEST_F(SlowViewer, ReceivesNothingThatItUnsubscribed) {
  add_frame();
  mailbox.forget(1);
  mailbox.forget(2);
  reader.begin_to_answer();
  mailbox.add_frame(++time, {frame_message(3, "other")});
  for (const std::string& one : take_until("other")) EXPECT_NE(one, "frame " + std::to_string(time - 1));
}

TEST_F(SlowViewer, CannotAnswerPingsThatWereNotSent) {
  const std::vector<std::byte> later(8, std::byte{0x7F}), odd(3), empty;
  for (const auto& bytes : {later, odd, empty}) mailbox.receive_pong(bytes);
  const std::uint64_t before = mailbox.left_out().frames;
  add_frame();
  EXPECT_EQ(mailbox.left_out().frames, before + 1) << "it waits";
}

TEST_F(SlowViewer, IsClosedWhileAFrameWaits) {
  const int pings = reader.pings;
  mailbox.close(kNormalClose, "the end");
  EXPECT_NE(reader.take().find("the end"), std::string::npos);
  EXPECT_EQ(reader.take(), "closed");
  EXPECT_EQ(reader.pings, pings) << "nothing follows a close frame";
}

/// The last news of 2 s with 30 frames a second, of which each `sends_each`-th is sent.
std::string news_of_pass(RateStatus& rate, double begin, int sends_each, int images, bool shows_rates) {
  std::optional<std::string> news;
  for (int i = 0; i < 60; ++i) {
    rate.add_frame(1);
    if (i % sends_each == 0) rate.send_frame();
    if (i < images) rate.send_image();
    if (const auto one = rate.take_news(begin + i / 30.0, shows_rates)) news = one;
  }
  return news.value_or("");
}

TEST(RateStatus, ReportsTheRatesOfASlowViewerAndItsEnd) {
  RateStatus rate;
  const auto pass = [&](double begin, int sends_each, int images) {
    return news_of_pass(rate, begin, sends_each, images, true);
  };
  EXPECT_EQ(pass(0.0, 1, 60), "");
  EXPECT_EQ(pass(2.0, 1, 60), "") << "a good connection";
  pass(4.0, 5, 2);
  const std::string slow = pass(6.0, 5, 2);
  EXPECT_NE(slow.find("slow connection or busy viewer: 6 of 30 frames, 1 of 30 images a second"), std::string::npos)
      << slow;
  EXPECT_NE(slow.find(R"("id":"slow")"), std::string::npos) << slow;
  pass(8.0, 5, 0);
  EXPECT_NE(pass(10.0, 4, 0).find("0 of 30 images"), std::string::npos);
  pass(12.0, 1, 60);
  pass(14.0, 1, 60);
  EXPECT_NE(pass(16.0, 1, 60).find("removeStatus"), std::string::npos);
  EXPECT_EQ(pass(18.0, 1, 60), "");
  EXPECT_GT(rate.left_out().frames, 100u);
}

TEST(RateStatus, HasOneTextForViewersThatListEachText) {
  RateStatus rate;
  news_of_pass(rate, 0.0, 1, 60, false);
  news_of_pass(rate, 2.0, 5, 2, false);
  const std::string slow = news_of_pass(rate, 4.0, 5, 2, false);
  EXPECT_NE(slow.find("\"slow connection or busy computer: some frames or images are left out\""), std::string::npos)
      << slow;
  EXPECT_EQ(news_of_pass(rate, 6.0, 2, 30, false), "");
  EXPECT_EQ(news_of_pass(rate, 8.0, 6, 0, false), "");
}

TEST(RateStatus, NamesABusyComputerIfTheSenderWaitsMuchLongerThanPlanned) {
  const auto text = [](double planned, double taken) {
    RateStatus rate;
    rate.take_news(0.0, true);
    for (int i = 0; i < 60; ++i) {
      rate.add_frame(0);
      rate.add_wait(planned, taken);
    }
    return rate.take_news(2.0, true).value_or("");
  };
  EXPECT_NE(text(0.01, 0.0101).find("slow connection or busy viewer: 0 of 30"), std::string::npos);
  EXPECT_NE(text(0.01, 0.03).find("busy computer: 0 of 30"), std::string::npos);
}

TEST(ViewerMailbox, WakesItsReader) {
  ViewerMailbox mailbox(kSmall);
  auto taken = std::async(std::launch::async, [&] { return mailbox.wait().has_value(); });
  mailbox.add_data(message("x"), Importance::data);
  EXPECT_TRUE(taken.get());
}

}  // namespace
}  // namespace reorient::live
