// SPDX-License-Identifier: MIT
// The events of a run that are printed during the run.
#include "program/run/timeline_printer.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace reorient {
namespace {

class TimelinePrinterTest : public ::testing::Test {
 protected:
  TimelinePrinterTest() {
    for (const char* machine : {"orientation", "busy"}) transition(machine);
    frame.names = names.table();
  }
  NameId id(const std::string& name) { return names.intern(name); }
  Issuer issuer() { return {id("orientation"), id("correcting"), id("the opposite pose won")}; }
  TransitionRecord transition(const std::string& machine) {
    return {id(machine), id("watching"), id("correcting"), id("the opposite pose won"), 0};
  }
  /// The text that is printed in a frame at `time`.
  std::string printed(TimelinePrinter& printer, double time) {
    out.str("");
    frame.world.time = time;
    printer.observe(frame, scene);
    return out.str();
  }

  Names names;
  FrameRecord frame;
  SceneTruth scene;
  std::ostringstream out;
};

TEST_F(TimelinePrinterTest, PrintsInTheFrameInWhichItHappens) {
  TimelinePrinter printer(out, false);
  EXPECT_EQ(printed(printer, 1.0), "");
  frame.transitions.push_back(transition("orientation"));
  const std::string text = printed(printer, 2.0);
  EXPECT_NE(text.find("time  behavi"), std::string::npos) << "a header before the first line";
  EXPECT_NE(text.find("  2.00 s  orientation           watching > correcting (the opposite pose won)\n"),
            std::string::npos)
      << text;
}

/// The operator repeats a note on purpose; a script that repeats one in each frame is counted.
TEST_F(TimelinePrinterTest, PrintsEachNoteOfTheOperator) {
  TimelinePrinter printer(out, false);
  frame.logs.push_back({0, 0, "moved the robot", 0, true});
  for (const double time : {1.0, 2.0, 3.0})
    EXPECT_NE(printed(printer, time).find("note: moved the robot\n"), std::string::npos) << time;
  frame.logs[0].machine = id("viewer");
  frame.names = names.table();
  for (const double time : {3.1, 3.2})
    EXPECT_NE(printed(printer, time).find("viewer                note: moved the robot\n"), std::string::npos) << time;
  frame.logs[0].machine = id("busy");
  EXPECT_NE(printed(printer, 4.0), "");
  EXPECT_EQ(printed(printer, 5.0), "");
}

TEST_F(TimelinePrinterTest, CountsRepeatedEventsAndPrintsTheCountAtTheEnd) {
  TimelinePrinter printer(out, false);
  frame.transitions.push_back(transition("busy"));
  EXPECT_NE(printed(printer, 0.0), "");
  EXPECT_EQ(printed(printer, 5.0), "");
  EXPECT_EQ(printed(printer, 14.0), "") << "ten seconds since it came last, not since it was printed";
  EXPECT_NE(printed(printer, 24.0), "");
  printer.finish(frame, scene);
  EXPECT_NE(out.str().find("busy                  2 events repeated"), std::string::npos) << out.str();
}

TEST_F(TimelinePrinterTest, PrintsAllEventsOnRequestAndAlwaysGrantedCommands) {
  TimelinePrinter everything(out, true);
  frame.transitions.push_back(transition("busy"));
  EXPECT_NE(printed(everything, 0.0), "");
  EXPECT_NE(printed(everything, 0.1), "");

  TimelinePrinter printer(out, false);
  frame.transitions.clear();
  frame.commands.push_back({{Reorientation::flip_pose, issuer(), 50.0}, Verdict::granted});
  EXPECT_NE(printed(printer, 0.0), "");
  EXPECT_NE(printed(printer, 0.1), "") << "a second flip is printed";
  frame.commands[0].verdict = Verdict::too_soon;
  EXPECT_NE(printed(printer, 0.2), "");
  EXPECT_EQ(printed(printer, 0.3), "") << "refused again, as before";
}

TEST_F(TimelinePrinterTest, UsesBoundedMemoryForAnyNumberOfDifferentEvents) {
  TimelinePrinter printer(out, false);
  constexpr std::size_t kReasons = 3 * TimelinePrinter::kMostRemembered;
  NameTable table = *names.table();
  std::vector<TransitionRecord> flood(kReasons, transition("busy"));
  for (TransitionRecord& one : flood) {
    one.reason = static_cast<NameId>(table.names.size());
    table.names.push_back("reason " + std::to_string(one.reason));
  }
  frame.names = std::make_shared<NameTable>(std::move(table));
  std::ptrdiff_t lines = 0;
  for (std::size_t i = 0; i < kReasons; i += 100) {
    frame.transitions.assign(flood.begin() + static_cast<std::ptrdiff_t>(i),
                             flood.begin() + static_cast<std::ptrdiff_t>(i) + 100);
    const std::string text = printed(printer, 1e-4 * static_cast<double>(i));
    lines += std::count(text.begin(), text.end(), '\n');
  }
  EXPECT_LE(lines, static_cast<std::ptrdiff_t>(TimelinePrinter::kMostRemembered) + 1);
  frame.transitions = {transition("orientation")};
  EXPECT_NE(printed(printer, 20.0), "") << "after many events, new ones are printed again";
}

}  // namespace
}  // namespace reorient
