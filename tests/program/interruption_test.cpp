// SPDX-License-Identifier: MIT
// The outputs of an interrupted run.
#include <array>
#include <csignal>
#include <string>

#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "tests/program/program_run.h"
#include "tests/program/run_with_all_outputs.h"

namespace reorient {
namespace {

using InterruptedRun = RunWithAllOutputs;

/// Detects when a program opens a file.
class OpenedFile {
 public:
  explicit OpenedFile(const std::filesystem::path& file) : watch_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (inotify_add_watch(watch_, file.c_str(), IN_OPEN) < 0) ADD_FAILURE() << "no watch of " << file;
  }
  ~OpenedFile() { close(watch_); }
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;

  bool await() const {
    std::array<char, 4096> events;
    return reorient::await([&] { return read(watch_, events.data(), events.size()) > 0; });
  }

 private:
  int watch_;
};

class InterruptedBy : public InterruptedRun, public ::testing::WithParamInterface<int> {};

TEST_P(InterruptedBy, WritesAllOutputsOfTheUnfinishedRun) {
  for (const bool realtime : {false, true}) {
    SCOPED_TRACE(realtime);
    ChildProgram run(folder.path(),
                     words(realtime ? std::vector<std::string>{"--realtime"} : std::vector<std::string>{}));
    ASSERT_TRUE(run.await("patrol: "));
    ASSERT_TRUE(run.await("> waiting (start)\n")) << "the timeline is printed during the run";
    run.kill(GetParam());
    EXPECT_EQ(run.wait(), 128 + GetParam());
    const std::string verdict = GetParam() == SIGINT    ? "ended by its user with Ctrl-C"
                                : GetParam() == SIGTERM ? "ended by the signal SIGTERM"
                                                        : "ended by the signal SIGHUP";
    EXPECT_NE(run.out().find("not judged: " + verdict + "\n"), std::string::npos) << run.out();
    EXPECT_NE(run.out().find("digest: "), std::string::npos);
    EXPECT_EQ(json()["verdict"], verdict);
    EXPECT_TRUE(json()["succeeded"].is_null());
    EXPECT_GT(json()["frames"].get<int>(), 0);
    expect_all_outputs();
    EXPECT_EQ(left_overs(), 0);
    std::filesystem::remove_all(folder.path() / "pictures");
  }
}

TEST_P(InterruptedBy, ReportsTheTestsThatRan) {
  const std::filesystem::path scripts = copy_scripts(folder.path());
  const std::filesystem::path opened = folder.write("scripts/tests/opened.mcap", "no recording");
  const std::filesystem::path test = folder.write("scripts/tests/a_test.lua", R"(test("a", function() advance(1) end)
test("b", function()
  pcall(replay, "opened.mcap")
  load_behavior "head_scan"
  load_behavior "penalty_marks"
  while true do advance(0) end
end)
test("c", function() end))");
  const OpenedFile b_runs(opened);
  ChildProgram tests(folder.path(), {"test", test.string(), "--scripts", scripts.string(), "--junit",
                                     (folder.path() / "junit.xml").string()});
  ASSERT_TRUE(tests.await("a_test.lua: a\n"));
  ASSERT_TRUE(b_runs.await()) << "the second test prints nothing, but opens a file";
  let_time_pass(0.1);  // so that the signal usually arrives in its loop
  tests.kill(GetParam());
  EXPECT_EQ(tests.wait(), 128 + GetParam());
  EXPECT_NE(tests.out().find("1 passed, 1 failed, interrupted before the remaining tests\n"), std::string::npos)
      << tests.out();
  const std::string report = read_text(folder.path() / "junit.xml");
  EXPECT_NE(report.find("name=\"b\""), std::string::npos) << report;
  EXPECT_TRUE(report.ends_with("</testsuite>\n"));
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedBy, ::testing::Values(SIGINT, SIGTERM, SIGHUP), [](const auto& signal) {
  return std::string(signal.param == SIGINT ? "Int" : signal.param == SIGTERM ? "Term" : "Hup");
});

TEST_F(InterruptedRun, EndsAtOnceAfterTheSecondSignal) {
  ChildProgram run(folder.path(), words());
  ASSERT_TRUE(run.await("patrol: "));
  run.stop();  // so that both arrive before it continues
  run.kill(SIGINT);
  run.kill(SIGTERM);
  run.kill(SIGCONT);
  const int code = run.wait();
  EXPECT_TRUE(code == -SIGINT || code == -SIGTERM) << code;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run.json"));
}

TEST_F(InterruptedRun, ContinuesIfTheSignalIsIgnored) {
  ChildProgram run(folder.path(), words({"--seconds", "12"}), [] { std::signal(SIGHUP, SIG_IGN); });  // as nohup does
  ASSERT_TRUE(run.await("patrol: "));
  run.kill(SIGHUP);
  EXPECT_EQ(run.wait(), kWrong);
  EXPECT_EQ(json()["verdict"], "the scenario did not end in time");
}

}  // namespace
}  // namespace reorient
