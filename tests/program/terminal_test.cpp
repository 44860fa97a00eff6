// SPDX-License-Identifier: MIT
// The prompt at a terminal: keys, completion, history, and the restored terminal.
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/program/terminal_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

const std::vector<std::string> kPatrol{kProgram, "run", "patrol", "--realtime", "--width", "160", "--no-pictures"};

class AtATerminal : public ::testing::Test {
 protected:
  void SetUp() override {
    run.emplace(kPatrol, folder.path());
    if (!run->has_terminal()) GTEST_SKIP() << "no pseudo-terminal can be opened here";
    ASSERT_TRUE(run->await("real time"));
  }
  void open() {
    run->type("\n");
    ASSERT_TRUE(run->await("> "));
    ASSERT_TRUE(run->await_as_found(false)) << "a line of the timeline has \"> \", too";
  }
  /// Types, and waits for the expected output.
  void expect(const std::string& keys, const std::string& shown) {
    run->type(keys);
    EXPECT_TRUE(run->await(shown)) << keys << " showed " << run->shown();
  }
  /// The same as soon as the open prompt reads keys again: before, the terminal itself would show them.
  void edit(const std::string& keys, const std::string& shown) {
    EXPECT_TRUE(run->await_as_found(false)) << "before " << keys;
    expect(keys, shown);
  }
  std::string history() const { return read_text(folder.path() / "reorient" / "history"); }

  TemporaryFolder folder;
  std::optional<TerminalRun> run;
};

/// A stopped terminal accepts nothing until Ctrl-Q.
TEST(AtAStoppedTerminal, TheRunContinues) {
  const TemporaryFolder folder;
  const std::filesystem::path summary = folder.path() / "summary.json";
  std::vector<std::string> command = kPatrol;
  command.insert(command.end(), {"--seconds", "2", "--json", summary.string()});
  TerminalRun run(command, folder.path());
  if (!run.has_terminal()) GTEST_SKIP() << "no pseudo-terminal can be opened here";
  ASSERT_TRUE(run.await("real time"));
  run.type("\x13");
  ASSERT_TRUE(await([&] { return std::filesystem::exists(summary); })) << "the run waits for the terminal";
  EXPECT_EQ(run.shown().find("digest: "), std::string::npos) << "the terminal was not stopped";
  run.type("\x11");
  EXPECT_TRUE(run.await("digest: ")) << run.shown();
  run.wait();
}

TEST(AtAColoredTerminal, TheTimelineShowsWhatMatters) {
  const TemporaryFolder folder;
  constexpr const char* kGreen = "\x1B[32m";
  TerminalRun run({kProgram, "run", "--seconds", "45", "--width", "160", "--no-pictures"}, folder.path());
  if (!run.has_terminal()) GTEST_SKIP() << "no pseudo-terminal can be opened here";
  ASSERT_TRUE(run.await(kGreen));
  EXPECT_TRUE(run.await("flip_pose granted")) << run.shown();
  EXPECT_TRUE(run.await("\x1B[0m"));
  run.kill(SIGKILL);
  TerminalRun plain({kProgram, "run", "--color", "never", "--seconds", "45", "--width", "160", "--no-pictures"},
                    folder.path());
  EXPECT_TRUE(plain.await("flip_pose granted")) << plain.shown();
  EXPECT_EQ(plain.passed().find(kGreen), std::string::npos);
}

TEST_F(AtATerminal, CtrlDClosesThePromptAndTheRunContinues) {
  for (int i = 0; i < 2; ++i) {
    open();
    run->type("\x04");
    ASSERT_TRUE(run->await("real time")) << i;  // the progress line is back
    EXPECT_TRUE(run->await_as_found(true));
  }
  expect("states\n", "penalty_marks");
  expect("quit\n", "not judged: ended by its user with quit");
  expect("", "digest: ");
  EXPECT_EQ(run->wait(), 0) << "a normal end";
}

/// A longer line could not be overwritten, and left a line behind twice a second.
TEST_F(AtATerminal, TheStatusLineFitsIntoOneRow) {
  constexpr unsigned short kColumns = 40;
  run->resize(kColumns, 24);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(run->await("evidence"));  // the line that was begun before
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(run->await("evidence"));
    const std::string before = run->passed();
    ASSERT_TRUE(run->await("\r"));
    const std::string clear = "\x1B[K";
    const std::string line = before.substr(before.rfind(clear) + clear.size()) + "evidence" + run->passed();
    EXPECT_LT(line.size(), kColumns) << line;
  }
}

TEST_F(AtATerminal, NeedsNoMemoryForASizeThatNoTerminalHas) {
  run->resize(65535, 65535);
  run->type("\n");
  ASSERT_TRUE(run->await("> "));
  run->type("states\n");
  ASSERT_TRUE(run->await("penalty_marks"));
  run->type("quit\n");
  ASSERT_TRUE(run->await("digest: "));
  EXPECT_EQ(run->wait(), 0);
  rusage used{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &used), 0);
  constexpr long kMost = 500 * 1024;  // KiB; a place for each column and row took 1.9 GB
  EXPECT_LT(used.ru_maxrss, kMost);
}

TEST_F(AtATerminal, EditsTheLineAlsoAfterAnAbsurdSize) {
  open();
  run->resize(65535, 65535);
  edit("st\t", "states ");
  run->resize(100, 30);
  expect("\n", "penalty_marks");
  expect("quit\n", "digest: ");
  EXPECT_EQ(run->wait(), 0);
}

TEST_F(AtATerminal, EditsTheLine) {
  open();
  edit("sett orientation.lingering 0.4\x01\x1B[C\x1B[C\x1B[C\x1B[3~\r", "orientation.lingering = 0.4\r\n");
  edit(
      "\x1B[A\x7F"
      "3\r",
      "orientation.lingering = 0.3\r\n");
  edit("undo\r", "orientation.lingering = 0.4\r\n");
  edit("params head_scan.speed\r", "head_scan.speed = 1");
  edit("linger\x12\r", "orientation.lingering = 0.3\r\n");  // the last line that holds "linger"
  edit("\x1B[5~für\x7F\x7F\x7Fundo\r",
       "orientation.lingering = 0.4\r\n");  // a key without effect; letters, not bytes
  edit("\x1B\r", "real time");              // Escape waits for nothing
  EXPECT_TRUE(run->await_as_found(true));
}

TEST_F(AtATerminal, CompletesWords) {
  open();
  edit("wh\torient\t\r", "the believed pose won");
  edit("set orientation.\t", "orientation.hold_time");
  edit("l\t0.25\r", "orientation.lingering = 0.25\r\n");
  edit("world confidence.opp\t\r", "confidence.opposite = ");
  edit("reload head\t\r", "behaviors/head_scan.lua was reloaded");
  edit("why pat\t\r", "patrol: walking");
}

TEST_F(AtATerminal, KeepsTheEditedLineBelowTheOutput) {
  open();
  run->type("watch clock.time\r");
  ASSERT_TRUE(run->await("clock.time = "));
  run->type("reload head");
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(run->await("clock.time = "));
    ASSERT_TRUE(run->await("\r\n"));
    ASSERT_TRUE(run->await("> reload head")) << "is drawn again";
  }
  run->type("_scan\r");
  ASSERT_TRUE(run->await("head_scan.lua: the edit is running")) << "the log";
  EXPECT_NE(run->passed().find("\r\x1B["), std::string::npos);
  ASSERT_TRUE(run->await("was reloaded"));
}

TEST_F(AtATerminal, DropsInputBeyondTheLongestLine) {
  open();
  const std::string block(1000, 'x');
  for (int i = 0; i < 30; ++i) run->type(block);
  expect("\r", "unknown command 'xxx");
  expect("states\r", "penalty_marks");
}

TEST_F(AtATerminal, RemembersLinesAcrossRuns) {
  open();
  expect("params head_scan.speed\r", "head_scan.speed = 1");
  expect("quit\r", "digest: ");
  run->wait();
  EXPECT_EQ(history(), "params head_scan.speed\nquit\n");
  run.emplace(kPatrol, folder.path());
  ASSERT_TRUE(run->await("real time"));
  open();
  expect("\x1B[A\x1B[A\r", "head_scan.speed = 1");
}

TEST_F(AtATerminal, RunsWithoutAHistoryIfItCannotBeUsed) {
  std::filesystem::create_directories(folder.path() / "reorient" / "history");
  run->type("\n");
  ASSERT_TRUE(run->await("the prompt keeps no history: "));
  ASSERT_TRUE(run->await("> "));
  expect("states\r", "penalty_marks");
  expect("quit\r", "digest: ");
  run->wait();
  EXPECT_EQ(run->shown().find("history"), std::string::npos) << "reported once";
}

// ---- the terminal is restored

TEST_F(AtATerminal, CtrlCEndsTheRunAndRestoresTheTerminal) {
  open();
  run->type("set orient");
  EXPECT_TRUE(run->await("set orient"));
  EXPECT_FALSE(run->is_as_found());
  run->type("\x03");
  EXPECT_TRUE(run->await("not judged: ended by its user with Ctrl-C"));
  EXPECT_EQ(run->wait(), 130);
  EXPECT_TRUE(run->is_as_found());
}

class EndedBy : public AtATerminal, public ::testing::WithParamInterface<int> {};

TEST_P(EndedBy, ASignalRestoresTheTerminal) {
  open();
  EXPECT_FALSE(run->is_as_found());
  run->kill(GetParam());
  const int code = run->wait();
  EXPECT_TRUE(code == 128 + GetParam() || code == -GetParam()) << code;
  EXPECT_TRUE(run->is_as_found());
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedBy, ::testing::Values(SIGTERM, SIGQUIT, SIGABRT), [](const auto& signal) {
  return std::string(signal.param == SIGTERM ? "Term" : signal.param == SIGQUIT ? "Quit" : "Abort");
});

TEST_F(AtATerminal, TheSecondSignalRestoresTheTerminal) {
  open();
  run->stop();  // so that both arrive before it continues
  run->kill(SIGINT);
  run->kill(SIGTERM);
  run->kill(SIGCONT);
  EXPECT_LT(run->wait(), 0);
  EXPECT_TRUE(run->is_as_found());
}

TEST_F(AtATerminal, CtrlZRestoresTheTerminalUntilTheRunContinues) {
  // A shell with job control: what it does while the program is stopped shows how the terminal is then.
  std::vector<std::string> shell{"/bin/sh", "-mc", "\"$@\"; stty -a; echo stopped; fg", "sh"};
  shell.insert(shell.end(), kPatrol.begin(), kPatrol.end());
  run.emplace(shell, folder.path());
  ASSERT_TRUE(run->await("real time"));
  open();
  run->type("states");
  ASSERT_TRUE(run->await("states"));
  run->type("\x1A");
  ASSERT_TRUE(run->await("stopped\r\n"));
  EXPECT_NE(run->passed().find(" icanon"), std::string::npos) << run->passed();
  EXPECT_NE(run->passed().find(" echo "), std::string::npos) << run->passed();
  ASSERT_TRUE(run->await("> states")) << "is drawn again";
  EXPECT_TRUE(run->await_as_found(false));
  expect("\r", "penalty_marks");
  expect("quit\r", "digest: ");
  run->wait();
  EXPECT_TRUE(run->is_as_found());
}

}  // namespace
}  // namespace reorient
