// SPDX-License-Identifier: MIT
// The events of a run as text, with a bounded number of stored commands.
#include "workbench/run/timeline.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

class TimelineTest : public ::testing::Test {
 protected:
  TimelineTest() {
    for (const char* name : {"orientation", "watching", "correcting", "the opposite pose won", "busy"})
      names.intern(name);
    frame.names = names.table();
  }
  NameId id(const std::string& name) { return names.intern(name); }
  Issuer issuer() { return {id("orientation"), id("correcting"), id("the opposite pose won")}; }
  TransitionRecord transition(const std::string& machine) {
    return {id(machine), id("watching"), id("correcting"), id("the opposite pose won"), 0};
  }

  Names names;
  FrameRecord frame;
  SceneTruth scene;
  CommandHistory history;
};

TEST_F(TimelineTest, ListsChangesOfStatePausesAndCommandsInOrder) {
  frame.world.time = 4.0;
  frame.transitions.push_back(transition("orientation"));
  frame.begun.push_back({Pause::training, issuer()});
  frame.commands.push_back({{Reorientation::flip_pose, issuer(), 50.0}, Verdict::too_soon});
  const std::vector<TimelineEvent> events = timeline_events(frame, scene);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].state, "watching > correcting");
  EXPECT_EQ(events[0].reason, "the opposite pose won");
  EXPECT_EQ(events[0].time, 4.0);
  EXPECT_EQ(events[1].command, "pause_training");
  EXPECT_EQ(events[1].verdict, "granted");
  EXPECT_EQ(events[2].command, "flip_pose");
  EXPECT_EQ(events[2].verdict, "too_soon");
  EXPECT_EQ(events[2].state, "correcting");
  history.observe(frame, scene);
  ASSERT_EQ(history.commands().size(), 2u);
  EXPECT_EQ(history.commands()[0].command, "pause_training");
  EXPECT_EQ(history.dropped(), 0u);
}

TEST_F(TimelineTest, ContainsNotesAndNoOtherLogLines) {
  frame.logs.push_back({kNoName, kNoName, "the referee moved it", 0, true});
  frame.logs.push_back({id("orientation"), id("watching"), "hello", 0, false});
  frame.logs.push_back({id("orientation"), id("watching"), "look here", 0, true});
  const std::vector<TimelineEvent> events = timeline_events(frame, scene);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].machine, "note");
  EXPECT_EQ(events[0].state, "note: the referee moved it");
  EXPECT_EQ(events[1].machine, "orientation");
  EXPECT_EQ(events[1].state, "note: look here");
}

TEST_F(TimelineTest, ReportsThatTheTeamsChangeSides) {
  EXPECT_TRUE(timeline_events(frame, scene).empty());
  frame.inputs.half_time = true;
  const std::vector<TimelineEvent> events = timeline_events(frame, scene);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].machine, "game");
  EXPECT_EQ(events[0].state, "half-time");
  EXPECT_FALSE(events[0].reorients);
}

TEST_F(TimelineTest, StoresTheLatestCommandsOfEachMachineAndCountsTheRest) {
  frame.begun.push_back({Pause::training, issuer()});
  history.observe(frame, scene);
  frame.begun[0].issuer.machine = id("busy");
  for (int i = 0; i < 10'000; ++i) {
    frame.world.time = i;
    history.observe(frame, scene);
  }
  const std::vector<TimelineEvent> commands = history.commands();
  ASSERT_EQ(commands.size(), CommandHistory::kMostOfAMachine + 1);
  EXPECT_EQ(commands.front().machine, "orientation") << "a busy machine hides no other";
  EXPECT_EQ(commands.back().time, 9'999.0);
  EXPECT_EQ(history.dropped(), 10'000u - CommandHistory::kMostOfAMachine);
}

TEST_F(TimelineTest, UsesBoundedMemoryForAnyNumberOfMachines) {
  for (int i = 0; i < 1000; ++i) {
    frame.begun = {{Pause::training, {id("edited_" + std::to_string(i)), 0, 0}}};
    frame.names = names.table();
    history.observe(frame, scene);
  }
  // One of each machine with its own storage, and the latest of the others.
  EXPECT_LE(history.commands().size(), CommandHistory::kMostMachines + CommandHistory::kMostOfAMachine);
}

}  // namespace
}  // namespace reorient
