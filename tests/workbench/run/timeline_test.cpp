// Events in words, of which a bounded number is kept.
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

  Names names;
  FrameRecord frame;
  StageRecord stage;
  Timeline timeline;
};

TEST_F(TimelineTest, TellsChangesOfStatePausesAndCommandsInTheirOrder) {
  frame.world.time = 4.0;
  const Issuer issuer{id("orientation"), id("correcting"), id("the opposite pose won")};
  frame.transitions.push_back({id("orientation"), id("watching"), id("correcting"), issuer.reason, 0});
  frame.begun.push_back({Pause::training, issuer});
  frame.commands.push_back({{Reorientation::flip_pose, issuer, 50.0}, Verdict::too_soon});
  timeline.observe(frame, stage);
  const MachineEvents& events = timeline.machines().at("orientation");
  ASSERT_EQ(events.transitions.size(), 1u);
  EXPECT_EQ(events.transitions[0].state, "watching > correcting");
  EXPECT_EQ(events.transitions[0].reason, "the opposite pose won");
  EXPECT_EQ(events.transitions[0].time, 4.0);
  const std::vector<TimelineEvent> commands = timeline.commands();
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(commands[0].command, "pause_training");
  EXPECT_EQ(commands[0].verdict, "granted");
  EXPECT_EQ(commands[1].command, "flip_pose");
  EXPECT_EQ(commands[1].verdict, "too_soon");
  EXPECT_EQ(commands[1].state, "correcting");
}

TEST_F(TimelineTest, KeepsTheLatestOfEachMachineAndCountsTheRest) {
  frame.transitions.push_back({id("orientation"), id("watching"), id("correcting"), 0, 0});
  timeline.observe(frame, stage);
  frame.transitions[0].machine = id("busy");
  for (int i = 0; i < 10'000; ++i) {
    frame.world.time = i;
    timeline.observe(frame, stage);
  }
  const MachineEvents& busy = timeline.machines().at("busy");
  EXPECT_EQ(busy.transitions.size(), Timeline::kMostOfAMachine);
  EXPECT_EQ(busy.transition_count, 10'000u);
  EXPECT_EQ(busy.transitions.back().time, 9'999.0);
  EXPECT_EQ(timeline.machines().at("orientation").transitions.size(), 1u) << "a busy machine hides no other";
}

TEST_F(TimelineTest, TakesABoundedMemoryHoweverManyMachinesThereWere) {
  for (int i = 0; i < 1000; ++i) {
    frame.transitions = {{id("edited_" + std::to_string(i)), 0, 0, 0, 0}};
    frame.names = names.table();
    timeline.observe(frame, stage);
  }
  EXPECT_LE(timeline.machines().size(), Timeline::kMostMachines + 1);
}

}  // namespace
}  // namespace reorient
