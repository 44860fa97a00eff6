// SPDX-License-Identifier: MIT
// Arbitrary texts as a file of scripted tests, with the shipped behaviors: any test ends soon, and its messages are
// readable text.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/fuzz/promises.h"
#include "tests/paths.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/testing/junit_report.h"
#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {
namespace {

constexpr int kMostQuestions = 400;  // largest number of calls of stop(), before each test and each frame
constexpr std::int64_t kInstructions = 200'000;
constexpr std::size_t kLongestText = 20'000;

/// A simulation that ends at once with success.
SimulationOutcome pretend(const SimulationRequest& request, CoverageTrace&, const std::function<bool()>&) {
  SimulationOutcome outcome;
  outcome.is_correct = request.seed % 2 == 1;
  outcome.seconds = request.seconds;
  outcome.seen.logs = request.with;
  outcome.seen.machines.push_back({request.scenario, "done"});
  return outcome;
}

void look_at(const TestCase& test) {
  require(test.name.size() <= kLongestText, "a name can be read");
  require(!test.skipped, "no test is skipped with a simulator");
  for (const TestFailure& failure : test.failures) {
    require(!failure.text.empty(), "a failure has a reason");
    require(failure.text.size() <= kLongestText, "a failure can be read");
  }
}

void try_tests(std::string_view text) {
  static const std::string root = std::string(kSourceFolder) + "/scripts";
  static const ScriptTexts scripts = read_scripts(root);
  int asked = 0;
  TestRun run;
  run.scripts_root = root;
  run.simulate = pretend;
  run.timeout = 1.0;
  run.stop = [&asked] { return ++asked > kMostQuestions; };
  run.instructions = kInstructions;
  CoverageTrace trace;
  TestSummary summary;
  const Haste haste(8.0);
  run_test_text("tests/fuzzed_test.lua", std::string(text), run, scripts, trace, [&](TestCase test) {
    look_at(test);
    summary.cases.push_back(std::move(test));
  });
  require(!summary.cases.empty() || asked > kMostQuestions, "each file has a result");
  for (const char letter : junit_report(summary, {"host", "2026-11-29T15:30:00"})) {
    const auto code = static_cast<unsigned char>(letter);
    require(code >= ' ' || letter == '\n' || letter == '\t', "a report has no control characters");
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_tests({reinterpret_cast<const char*>(data), size});
  return 0;
}
