// SPDX-License-Identifier: MIT
// Scripted behavior tests: scripts/tests/*_test.lua, in a fake world with a fake clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

#include "workbench/script_tools/testing/coverage.h"
#include "workbench/script_tools/testing/simulation.h"
#include "workbench/script_tools/testing/test_bench.h"

namespace reorient {

struct TestCase {
  std::string file;
  std::string name;
  std::vector<TestFailure> failures;   ///< empty: it passed
  bool skipped = false;                ///< it requires the simulator, which is not available
  std::set<std::string> warnings{};    ///< of former names that it uses
  bool has_run = true;                 ///< false: its file cannot run, or the time of its file was over
  double seconds = 0.0;                ///< in wall-clock time
  std::vector<std::string> printed{};  ///< by the test; each may have several lines
};

struct TestSummary {
  std::vector<TestCase> cases;  ///< a file that cannot run is a separate case
  int passed = 0;
  int failed = 0;
  int skipped = 0;
  bool interrupted = false;  ///< it ended before the last test
};

/// Configuration of a run of tests.
struct TestRun {
  std::filesystem::path scripts_root;
  std::vector<std::filesystem::path> paths;  ///< files and folders; empty: all of scripts_root/tests
  Simulate simulate;                         ///< empty: tests that require the simulator are skipped
  PlayRecording play_recording;              ///< empty: tests that replay a recording fail
  double timeout = 60.0;                     ///< s in wall-clock time for each test; a file has ten times that
  std::function<bool()> stop;                ///< called before each frame; empty: no interrupt
  std::function<void(const std::string& file, const std::string& name)> begin{};  ///< before each test; may be empty
  std::function<void()> end{};             ///< after each test, before its result is written; may be empty
  std::int64_t instructions = 50'000'000;  ///< limit of Lua instructions for each test
  LoadInterface load_interface{};          ///< empty: tests that load the interface of an application fail
};

/// Writes one line per test, what it printed, and each failure with file, line, expected and actual value. Fills
/// `trace` with the covered states and transitions. Each test runs in a fresh sandbox, after its file has run again in
/// it. Throws std::runtime_error with one line if a path does not exist or contains no tests.
TestSummary run_script_tests(const TestRun& run, std::ostream& out, CoverageTrace& trace);

/// Runs the tests of one file's text with these scripts; run.paths is not used. Calls `take` with each case as soon as
/// it is complete.
void run_test_text(const std::string& name, const std::string& text, const TestRun& run, const ScriptTexts& scripts,
                   CoverageTrace& trace, const std::function<void(TestCase)>& take);

}  // namespace reorient
