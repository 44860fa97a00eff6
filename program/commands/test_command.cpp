// SPDX-License-Identifier: MIT
// `reorient test`: scripted behavior tests, in a fake world and on the simulator.
#include <array>
#include <chrono>
#include <ctime>
#include <functional>
#include <memory>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/progress_line.h"
#include "program/recording/test_replay.h"
#include "program/run/simulation.h"
#include "program/run/venue.h"
#include "program/safe_output.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/script_files.h"
#include "workbench/run/run_loop.h"
#include "workbench/run/run_summary.h"
#include "workbench/script_tools/testing/junit_report.h"
#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {
namespace {

struct TestOptions {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path scripts;
  bool simulator = false;
  double timeout = 60.0;
  bool coverage = false;
  std::filesystem::path junit;
};

/// The test that runs, and how far its simulation is.
class TestProgress : public Observer {
 public:
  explicit TestProgress(std::ostream& err) : line_(err, std::chrono::milliseconds(300)) {}

  void begin(const std::string& file, const std::string& name) {
    test_ = file + ": " + name;
    line_.restart();
  }
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    if (line_.is_due()) line_.show(fmt::format("{:.0f} s simulated  {}", frame.world.time, test_));
  }
  void clear() { line_.clear(); }

 private:
  ProgressLine line_;
  std::string test_;
};

/// Records the states and transitions of a run.
class CoverageObserver : public Observer {
 public:
  CoverageObserver(Simulation& simulation, CoverageTrace& trace) : simulation_(simulation), trace_(trace) {}

  void observe(const FrameRecord& frame, const SceneTruth& scene) override {
    if (!frame.transitions.empty()) trace_.note(simulation_.engine().machines(), *frame.names, frame.transitions);
    const ScenarioRecord& scenario = scene.scenario;
    if (!scenario.transitions.empty())
      trace_.note(simulation_.scenario().machines(), *scenario.names, scenario.transitions);
  }

 private:
  Simulation& simulation_;
  CoverageTrace& trace_;
};

/// A test may name scripts below the root only. Throws std::runtime_error for the path of another file, without looking
/// whether it exists.
void require_script_below(const std::filesystem::path& scripts, const char* folder, const std::string& name) {
  const bool is_path = name.ends_with(".lua") || name.find('/') != std::string::npos;
  if (is_path && read_scripts(scripts).find(script_file(folder, name)) == nullptr)
    throw std::runtime_error("simulate: expected a script below the root of the scripts, found '" + name + "'");
}

SimulationOutcome simulate(const std::filesystem::path& scripts, const SimulationRequest& request, CoverageTrace& trace,
                           const std::function<bool()>& stop, TestProgress& progress) {
  require_script_below(scripts, "scenarios", request.scenario);
  for (const std::string& behavior : request.with) require_script_below(scripts, "behaviors", behavior);
  SimulationOptions options;
  options.scenario = request.scenario;
  options.with = request.with;
  options.scripts = scripts;
  options.seed = request.seed;
  options.width = request.width;
  options.seconds = request.seconds;
  options.room = room_named_by_script(scripts, request.room);
  options.hall_seed = request.hall_seed;
  options.field = field_named_by_script(scripts, request.field);
  options.room_awareness = request.room_awareness;
  for (const auto& [name, value] : request.parameters)
    options.parameters.assignments.emplace_back(name).append("=").append(value);
  Simulation simulation(options);
  SummaryObserver summary;
  SeenObserver seen;
  CoverageObserver coverage(simulation, trace);
  RunParts parts = simulation.parts();
  parts.observers = {&summary, &seen, &coverage, &progress};
  parts.stop = stop;
  RunLoop(std::move(parts)).run();
  const RunSummary result = summary.summary();
  return {result.correct, result.seconds, std::move(seen.seen)};
}

JunitOrigin junit_origin() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  return {host.data(), fmt::format("{:%FT%T}", fmt::gmtime(std::time(nullptr)))};
}

int test(const TestOptions& options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  TestRun run;
  run.scripts_root = scripts_root(options.scripts);
  run.paths = options.paths;
  run.play_recording = recordings_below(run.scripts_root);
  run.load_interface = [root = run.scripts_root](const std::string& name) {
    return interface_named(interface_named_by_script(root, name));
  };
  run.timeout = options.timeout;
  run.stop = [] { return Interruption::signal() != 0; };
  NamedFiles files;
  files.reads_scripts(run.scripts_root);
  for (const std::filesystem::path& path : options.paths) files.reads(path, "a test");
  files.require_writable(options.junit, "--junit");
  TestProgress progress(err);
  if (options.simulator) {
    run.begin = [&progress](const std::string& file, const std::string& name) { progress.begin(file, name); };
    run.end = [&progress] { progress.clear(); };
    run.simulate = [&](const SimulationRequest& request, CoverageTrace& more, const std::function<bool()>& stop) {
      return simulate(run.scripts_root, request, more, stop, progress);
    };
  }
  const JunitOrigin origin = junit_origin();
  CoverageTrace trace;
  const TestSummary summary = run_script_tests(run, out, trace);
  std::set<std::string> warnings;
  for (const TestCase& one : summary.cases) {
    for (const std::string& warning : one.warnings) warnings.insert(one.file + ": " + warning);
  }
  for (const std::string& warning : warnings) spdlog::warn("{}", warning);
  std::vector<std::string> failures;
  if (!options.junit.empty())
    try_to_write(failures, [&] { write_whole_file(options.junit, junit_report(summary, origin)); });
  if (options.coverage) {
    out << "\n";
    try_to_write(failures, [&] {
      for (std::string& failure : report_coverage(trace, run.scripts_root, out)) failures.push_back(std::move(failure));
    });
  }
  for (const std::string& failure : failures) print_error(err, failure);
  if (!failures.empty()) return kBadInput;
  if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());
  return summary.failed == 0 ? kSuccess : kWrong;
}

}  // namespace

Subcommand add_test(CLI::App& program) {
  const auto options = std::make_shared<TestOptions>();
  CLI::App* const parser = program.add_subcommand("test", "run scripted behavior tests")->fallthrough();
  set_examples(*parser, {{"reorient test", "all tests"},
                         {"reorient test scripts/tests/orientation_test.lua", "one file"},
                         {"reorient test --coverage", "also what no test covers"},
                         {"reorient test --simulator", "also whole scenarios on the simulator"}});
  parser->add_option("paths", options->paths, "test files or folders (default: tests/ of the scripts)")
      ->type_name("PATH");
  parser->add_flag("--simulator", options->simulator, "run the tests that simulate whole scenarios, too");
  parser->add_flag("--coverage", options->coverage, "list the states and transitions that no test took");
  parser->add_option("--timeout", options->timeout, "time limit of a test in seconds; of a file, ten times as much")
      ->type_name("SECONDS")
      ->check(check_seconds)
      ->capture_default_str();
  parser->add_option("--junit", options->junit, "write the results as JUnit XML, for CI systems")->type_name("FILE");
  add_scripts_option(*parser, options->scripts, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream& err) { return test(*options, out, err); }};
}

}  // namespace reorient
