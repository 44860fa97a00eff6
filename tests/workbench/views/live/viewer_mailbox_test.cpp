// SPDX-License-Identifier: MIT
// The messages that wait for a viewer: bounded, images are dropped first, answers never without ending the connection.
#include "workbench/views/live/server/viewer_mailbox.h"

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

TEST(ViewerMailbox, WakesItsReader) {
  ViewerMailbox mailbox(kSmall);
  auto taken = std::async(std::launch::async, [&] { return mailbox.wait().has_value(); });
  mailbox.add_data(message("x"), Importance::data);
  EXPECT_TRUE(taken.get());
}

}  // namespace
}  // namespace reorient::live
