// SPDX-License-Identifier: MIT
// Messages between teammates: the ones that a behavior receives, and the ones that it sends.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

constexpr const char* kEcho = R"(behavior "tested" { update = function()
  for i = 1, team.heard() do team.send(team.sender(i) .. " said " .. team.text(i)) end
end })";

TEST(Messages, AreReadInOrderInTheFrameThatContainsThem) {
  HandFedLoop loop(kEcho);
  loop.inputs.observation.external.messages = {{2, "hello"}};
  loop.inputs.external.messages = {{3, "and I"}};
  EXPECT_EQ(loop.step().answer.messages, (std::vector<std::string>{"2 said hello", "3 said and I"}));
  EXPECT_EQ(loop.record().inputs.messages.size(), 2u);
  loop.inputs.observation.external = {};
  EXPECT_TRUE(loop.step().answer.messages.empty());
  EXPECT_TRUE(loop.record().inputs.messages.empty());
}

TEST(Messages, AreTruncatedToTheirLimits) {
  HandFedLoop loop(R"(behavior "tested" { update = function()
    if team.heard() > 0 then log.info(team.heard() .. " " .. #team.text(1)) end
  end })");
  loop.inputs.external.messages.assign(1000, {1, std::string(5000, 'x')});
  ASSERT_EQ(loop.step().logs.size(), 1u);
  EXPECT_EQ(loop.record().logs[0].text, "32 240");
}

TEST(Messages, MayContainAnyBytesIfReceived) {
  HandFedLoop loop(R"(behavior "tested" { update = function()
    if team.heard() > 0 then log.info(tostring(#team.text(1))) end
  end })");
  loop.inputs.external.messages = {{1, std::string("\0\xff\n", 3)}};
  ASSERT_EQ(loop.step().logs.size(), 1u);
  EXPECT_EQ(loop.record().logs[0].text, "3");
}

TEST(Messages, WithAnUnknownIndexAreAnError) {
  for (const char* which : {"1", "0", "-1", "2^53"}) {
    HandFedLoop loop(std::string("behavior \"tested\" { update = function() team.text(") + which + ") end }");
    ASSERT_FALSE(loop.step().faults.empty()) << which;
    EXPECT_NE(loop.record().faults[0].fault.message.find("this frame has 0 messages"), std::string::npos) << which;
  }
}

TEST(Messages, AreRefusedIfTheyAreTooLongOrContainZeroBytes) {
  const struct {
    const char* text;
    const char* refusal;
  } cases[] = {{"string.rep('x', 241)", "message has 241 bytes (expected at most 240)"}, {"'a\\0b'", "zero byte"}};
  for (const auto& [text, refusal] : cases) {
    HandFedLoop loop(std::string("behavior \"tested\" { update = function() team.send(") + text + ") end }");
    ASSERT_FALSE(loop.step().faults.empty()) << text;
    EXPECT_NE(loop.record().faults[0].fault.message.find(refusal), std::string::npos) << refusal;
    EXPECT_TRUE(loop.record().answer.messages.empty());
  }
}

TEST(Messages, OfABehaviorThatSendsTooManyDoNotBlockOtherBehaviors) {
  FrameSetup setup;
  setup.scripts.apply(
      {"behaviors/chatterbox.lua",
       ScriptText{R"(behavior "chatterbox" { update = function() while true do team.send("me") end end })", ""}});
  setup.behaviors.emplace_back("chatterbox");
  HandFedLoop loop(R"(behavior "tested" { update = function() team.send("it is my turn") end })", std::move(setup));
  const std::vector<std::string>& said = loop.step().answer.messages;
  EXPECT_EQ(std::count(said.begin(), said.end(), "me"), 8);
  EXPECT_EQ(std::count(said.begin(), said.end(), "it is my turn"), 1);
  ASSERT_FALSE(loop.record().faults.empty());
  EXPECT_NE(loop.record().faults[0].fault.message.find("too many messages"), std::string::npos);
}

TEST(Messages, AreNotSentByACondition) {
  HandFedLoop loop(R"(behavior "tested" { initial = "a",
    state "a" { { "b", when = function() team.send("x") return team.heard() > 0 end } }, state "b" {} })");
  ASSERT_FALSE(loop.step(2).faults.empty());
  EXPECT_NE(loop.record().faults[0].fault.message.find("not allowed in a condition"), std::string::npos);
}

}  // namespace
}  // namespace reorient
