// `reorient test`: scripted behaviour tests, in a fake world and on the simulator.
#include <memory>
#include <ostream>
#include <sstream>

#include "program/program.h"
#include "program/run/simulated_run.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/run/run_history.h"
#include "workbench/script_tools/testing/junit_report.h"
#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {
namespace {

struct TestOptions {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path scripts;
  bool simulator = false;
  bool coverage = false;
  std::filesystem::path junit;
};

SimulationOutcome simulate(const std::filesystem::path& scripts, const SimulationRequest& request,
                           CoverageTrace& trace) {
  SimulationOptions options;
  options.scenario = request.scenario;
  options.with = request.with;
  options.scripts = scripts;
  options.seed = request.seed;
  options.width = request.width;
  options.seconds = request.seconds;
  options.room_awareness = request.room_awareness;
  for (const auto& [name, value] : request.parameters)
    options.parameters.assignments.emplace_back(name).append("=").append(value);
  SimulatedRun run(options);
  RunHistory history;
  SimulationOutcome outcome;
  while (run.step()) {
    const ScriptOutput& output = run.frame().script_output();
    history.add(run.frame());
    trace.note(run.scripts(), output);
    outcome.logs.insert(outcome.logs.end(), output.logs.begin(), output.logs.end());
    outcome.faults.insert(outcome.faults.end(), output.faults.begin(), output.faults.end());
  }
  outcome.verdict = run.verdict();
  outcome.is_correct = summarize(history, outcome.verdict).correct;
  outcome.machines = run.scripts().machines();
  outcome.commands = history.commands();
  outcome.transitions = history.transitions();
  return outcome;
}

int test(const TestOptions& options, std::ostream& out) {
  TestRun run{scripts_root(options.scripts), options.paths, {}};
  if (!options.junit.empty()) require_writable_file(options.junit, "--junit");
  if (options.simulator) {
    run.simulate = [&run](const SimulationRequest& request, CoverageTrace& trace) {
      return simulate(run.scripts_root, request, trace);
    };
  }
  CoverageTrace trace;
  const TestSummary summary = run_script_tests(run, out, trace);
  if (!options.junit.empty()) write_whole_file(options.junit, junit_report(summary));
  if (options.coverage) {
    out << "\n";
    report_coverage(trace, run.scripts_root, out);
  }
  return summary.failed == 0 ? kSuccess : kWrong;
}

}  // namespace

Subcommand add_test(CLI::App& program) {
  const auto options = std::make_shared<TestOptions>();
  CLI::App* const parser = program.add_subcommand("test", "run scripted behaviour tests")->fallthrough();
  parser->add_option("paths", options->paths, "test files or folders (default: tests/ of the scripts)");
  parser->add_flag("--simulator", options->simulator, "also the tests that run whole scenarios on the simulator");
  parser->add_flag("--coverage", options->coverage, "list the states and transitions that no test took");
  parser->add_option("--junit", options->junit, "write the results into this file, for CI systems");
  add_scripts_option(*parser, options->scripts);
  return {parser, [options](std::ostream& out, std::ostream&) { return test(*options, out); }};
}

}  // namespace reorient
