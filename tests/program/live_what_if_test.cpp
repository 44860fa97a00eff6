// SPDX-License-Identifier: MIT
// The requests and responses of the service what_if.
#include "program/run/live/live_what_if.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/script/script_texts.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient {
namespace {

using TriedJson = nlohmann::json;

std::string refusal_of(const std::string& payload) {
  try {
    read_what_if(payload, 100.0);
  } catch (const live::BadClientMessage& error) {
    return error.what();
  }
  return "";
}

TEST(WhatIfRequest, ReadsChangesAndTheTimeToReplay) {
  const WhatIfQuestion question =
      read_what_if(R"({"parameters":[{"name":"a.b","value":2.5}],"scripts":[{"file":"behaviors/x.lua","text":"--"}],)"
                   R"("seconds":12.5,"to":90})",
                   100.0);
  ASSERT_EQ(question.changes.parameters.size(), 1u);
  EXPECT_EQ(question.changes.parameters[0].name, "a.b");
  EXPECT_EQ(question.changes.parameters[0].value, "2.5");
  ASSERT_EQ(question.changes.scripts.size(), 1u);
  EXPECT_EQ(question.changes.scripts[0].text->text, "--");
  EXPECT_EQ(question.from, 77.5);
  EXPECT_EQ(question.to, 90.0);
  const WhatIfQuestion usual = read_what_if(R"({"parameters":[{"name":"a","value":true}],"to":1e9})", 100.0);
  EXPECT_EQ(usual.from, 70.0);
  EXPECT_EQ(usual.to, 100.0) << "not after the last frame";
}

TEST(WhatIfRequest, RefusesHostileValuesWithOneLine) {
  for (const char* payload :
       {"", "{", "[]", "{}", R"({"parameters":[]})", R"({"parameters":3})", R"({"parameters":[{"name":"a"}]})",
        R"({"parameters":[{"name":"a\n","value":null}]})", R"({"scripts":[{"file":"x.lua"}]})", R"({"scripts":["x"]})",
        R"({"scripts":[{"file":3,"text":""}]})"}) {
    const std::string refusal = refusal_of(payload);
    EXPECT_NE(refusal, "") << payload;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
  }
  const std::string change = R"({"parameters":[{"name":"a","value":1}],)";
  for (const char* bad : {R"("seconds":0})", R"("seconds":-1})", R"("seconds":601})", R"("seconds":1e400})",
                          R"("seconds":"x"})", R"("to":null})", R"("to":[]})"})
    EXPECT_NE(refusal_of(change + bad), "") << bad;
  TriedJson many{{"parameters", TriedJson::array()}};
  for (int i = 0; i < 201; ++i) many["parameters"].push_back({{"name", "a"}, {"value", i}});
  EXPECT_NE(refusal_of(many.dump()).find("at most 200, found 201"), std::string::npos);
  TriedJson scripts{{"scripts", TriedJson::array()}};
  for (int i = 0; i < 21; ++i) scripts["scripts"].push_back({{"file", "a"}, {"text", ""}});
  EXPECT_NE(refusal_of(scripts.dump()).find("at most 20, found 21"), std::string::npos);
}

TEST(WhatIfResponse, ShowsBothRunsAndWhereTheyPart) {
  WhatIfAnswer answer;
  for (int i = 0; i < 3; ++i) {
    WhatIfAnswer::Frame& frame = answer.frames.emplace_back();
    frame.time = 1.0 + i;
    frame.recorded.evidence = 0.123456;
    frame.tried.evidence = -i;
    frame.tried.status = RoomStatus::usable;
  }
  answer.frames[0].recorded.states = answer.frames[0].tried.states = {{"orientation", "watching"}};
  answer.frames[2].tried.states = {{"orientation", "correcting\xff"}};
  answer.events = {{2.0, "flip", true, false}};
  const TriedJson same = TriedJson::parse(what_if_json(answer, 0.5));
  EXPECT_EQ(same["from"], 1.0);
  EXPECT_EQ(same["to"], 3.0);
  EXPECT_EQ(same["frames"], 3);
  EXPECT_TRUE(same["first_decision"].is_null());
  EXPECT_TRUE(same["guess_from"].is_null());
  EXPECT_EQ(same["recorded"]["evidence"][0], 0.1235);
  EXPECT_EQ(same["tried"]["evidence"], TriedJson({0.0, -1.0, -2.0}));
  EXPECT_EQ(same["tried"]["status"][1], "usable");
  ASSERT_EQ(same["states"].size(), 2u);
  EXPECT_EQ(same["states"][0]["recorded"], true);
  EXPECT_EQ(same["states"][0]["tried"], true);
  EXPECT_EQ(same["states"][1]["recorded"], false);
  EXPECT_EQ(same["states"][1]["time"], 3.0);
  answer.first_decision = answer.events.front();
  answer.first_action = Difference{7, 2.5, "reorientation", "flip_pose", "nothing"};
  const TriedJson parted = TriedJson::parse(what_if_json(answer, 0.5));
  EXPECT_EQ(parted["first_decision"]["text"], "flip");
  EXPECT_EQ(parted["guess_from"], 2.5);
  EXPECT_EQ(parted["first_action"]["tried"], "nothing");
}

}  // namespace
}  // namespace reorient
