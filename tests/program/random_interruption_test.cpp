// SPDX-License-Identifier: MIT
// Runs that are interrupted at random times after their start: each output exists and is readable. A killed run leaves
// the old file or the new one. REORIENT_INTERRUPTIONS=50 sets the number of each kind; the default is small.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "tests/program/program_run.h"
#include "tests/program/run_with_all_outputs.h"

namespace reorient {
namespace {

int count_of_each() {
  const char* const wanted = std::getenv("REORIENT_INTERRUPTIONS");
  return wanted == nullptr ? 2 : std::atoi(wanted);
}

/// Whether the program handles the signal already. An emulator catches all signals from its own start: there the first
/// output of the program shows that it runs.
bool has_handler(const ChildProgram& program, int signal) {
#ifdef REORIENT_EMULATOR
  static_cast<void>(signal);
  return !program.out().empty();
#else
  std::ifstream status("/proc/" + std::to_string(program.id()) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    if ((std::stoull(line.substr(line.find('\t') + 1), nullptr, 16) >> (signal - 1) & 1U) != 0) return true;
  }
  return false;
#endif
}

class AtRandomMoments : public RunWithAllOutputs, public ::testing::WithParamInterface<int> {
 protected:
  /// Signals a program that takes about `seconds`, and waits for its end. What comes when it has done everything and
  /// only has to go away ends it as it ends any program.
  void interrupt(const std::vector<std::string>& all, double seconds, int own_code) {
    ChildProgram program(folder.path(), all);
    // On a slow machine this loop may only see the end of the program.
    ASSERT_TRUE(await([&] { return has_handler(program, GetParam()) || program.has_ended(); }, kOften));
    const double moment = random_.uniform(0.0, seconds);
    SCOPED_TRACE("after " + std::to_string(moment) + " s");
    let_time_pass(moment);
    program.kill(GetParam());
    const int code = program.wait();
    EXPECT_TRUE(code == 128 + GetParam() || code == own_code || code == -GetParam()) << code << program.err();
    interrupted_ += code == 128 + GetParam();
  }
  void forget_outputs() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
      std::filesystem::remove_all(entry.path());
  }
  void TearDown() override { RecordProperty("interrupted", interrupted_); }

 private:
  static constexpr std::chrono::milliseconds kOften{1};

  Random random_{static_cast<std::uint64_t>(GetParam())};
  int interrupted_ = 0;
};

TEST_P(AtRandomMoments, ARunWritesAllOutputs) {
  for (int i = 0; i < count_of_each() && !HasFailure(); ++i) {
    forget_outputs();
    ASSERT_NO_FATAL_FAILURE(interrupt(words({"--seconds", "6"}), 2.5, kWrong));
    expect_all_outputs();
    EXPECT_EQ(left_overs(), 0);
  }
}

TEST_P(AtRandomMoments, ARunInRealTimeWritesAllOutputs) {
  for (int i = 0; i < count_of_each() && !HasFailure(); ++i) {
    forget_outputs();
    ASSERT_NO_FATAL_FAILURE(interrupt(words({"--realtime", "--seconds", "3"}), 4.0, kWrong));
    expect_all_outputs();
    EXPECT_EQ(left_overs(), 0);
  }
}

TEST_P(AtRandomMoments, TestsWriteTheirReport) {
  for (int i = 0; i < count_of_each() && !HasFailure(); ++i) {
    forget_outputs();
    ASSERT_NO_FATAL_FAILURE(interrupt({"test", "--junit", (folder.path() / "junit.xml").string()}, 1.5, kSuccess));
    const std::string report = read_text(folder.path() / "junit.xml");
    EXPECT_TRUE(report.starts_with("<?xml")) << report;
    EXPECT_TRUE(report.ends_with("</testsuite>\n")) << report;
    EXPECT_EQ(left_overs(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, AtRandomMoments, ::testing::Values(SIGINT, SIGTERM, SIGHUP), [](const auto& signal) {
  return std::string(signal.param == SIGINT ? "Int" : signal.param == SIGTERM ? "Term" : "Hup");
});

using KilledRun = RunWithAllOutputs;

TEST_F(KilledRun, LeavesTheOldFileOrTheNewOne) {
  const auto run = [&](int seed) { return words({"--seconds", "1", "--seed", std::to_string(seed)}); };
  ASSERT_EQ(ChildProgram(folder.path(), run(1)).wait(), kWrong);
  Random random(9);
  const int count = std::max(36, 3 * count_of_each());
  int seed = 1;
  for (int i = 0; i < count && !HasFailure(); ++i) {
    ChildProgram killed(folder.path(), run(2 + i));
    let_time_pass(random.uniform(0.0, 1.0));
    killed.kill(SIGKILL);
    killed.wait();
    expect_all_outputs();
    const int found = json()["seed"].get<int>();
    EXPECT_TRUE(found == seed || found == 2 + i) << found;
    seed = found;
  }
  EXPECT_LT(left_overs(), count);
}

}  // namespace
}  // namespace reorient
