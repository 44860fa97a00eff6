// Scripted behaviour tests: scripts/tests/*_test.lua, in a fake world with a fake clock.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "engine/script/test_bench.h"

namespace reorient {

struct TestCase {
  std::string file;
  std::string name;
  std::vector<TestFailure> failures;  ///< none: it passed
};

struct TestSummary {
  std::vector<TestCase> cases;  ///< a file that cannot be run is a case of its own
  int passed = 0;
  int failed = 0;
};

/// Runs the tests in the files and folders of `paths`; without any: all of scripts_root/tests. Writes one line a test
/// and each failure with file, line, what was expected and what was seen. Throws std::runtime_error with one line when
/// a path does not exist or holds no tests.
TestSummary run_script_tests(std::span<const std::filesystem::path> paths, const std::filesystem::path& scripts_root,
                             std::ostream& out);

/// The summary as a JUnit report.
void write_junit(const TestSummary& summary, std::ostream& out);

}  // namespace reorient
