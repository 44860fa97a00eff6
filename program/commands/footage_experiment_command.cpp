// SPDX-License-Identifier: MIT
#include "program/commands/footage_experiment_command.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "engine/record/digest.h"
#include "program/experiment/countdown.h"
#include "program/experiment/outputs/report_folder.h"
#include "program/experiment/outputs/rows_report.h"
#include "program/experiment/task_results.h"
#include "program/experiment/worker_pool.h"
#include "program/footage/footage_tables.h"
#include "program/footage/footage_trials.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/program.h"
#include "program/safe_output.h"
#include "program/shell_word.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

struct FootageExperimentOptions {
  std::vector<std::string> sources;
  FootageSetup setup;
  FootageTrialOptions trials;
  double off_degrees = 10.0;
  int jobs = 1;
  std::filesystem::path out, json, report;
};

constexpr const char* kTold = "told";
constexpr const char* kOff = "told, off";
constexpr const char* kLifted = "lifted";
constexpr const char* kRight = "right";
constexpr const char* kMirrored = "mirrored";

std::vector<FootageCase> cases_of(const FootageTrialOptions& options) {
  using Kind = BeliefChange::Kind;
  std::vector<FootageCase> cases;
  for (const auto& [start, kind, turned_by] :
       {std::tuple{kTold, Kind::told, 0.0}, {kOff, Kind::told, options.turned_by}, {kLifted, Kind::lifted, 0.0}}) {
    for (const char* const pose : {kRight, kMirrored}) {
      BeliefChange change;
      change.kind = kind;
      change.turned_by = turned_by;
      change.mirrored = pose == kMirrored;
      cases.push_back({start, pose, change});
    }
  }
  return cases;
}

/// "kitchen" of "recordings/kitchen/".
std::string name_of(const std::filesystem::path& source) {
  const std::filesystem::path path = std::filesystem::absolute(source).lexically_normal();
  const std::string name = path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
  return name.empty() ? source.string() : name;
}

/// The description for tables and reports, in the form of other experiments.
Experiment experiment_of(const FootageExperimentOptions& options, const std::vector<std::string>& names) {
  Experiment experiment;
  experiment.name = "footage";
  experiment.title = "Footage: the pose is set right or mirrored at many moments";
  experiment.description = fmt::format(
      "Each trial continues from a robot that processed everything before with the recorded poses. Told: the pose is "
      "set; told, off: the same, {:g} degrees off; lifted: it is lifted and placed with the belief that it had. "
      "Watched for {:g} s.",
      options.off_degrees, options.trials.watch);
  experiment.trials = options.trials.starts;
  experiment.base.scenario = "footage";
  experiment.base.limit = options.trials.watch;
  experiment.base.hold = options.trials.hold;
  const auto axis = [&](const char* name, const std::vector<std::string>& choices) {
    Axis& one = experiment.axes.emplace_back();
    one.name = name;
    for (const std::string& choice : choices) one.choices.push_back({choice, {}});
  };
  axis("room", names);
  axis("start", {kTold, kOff, kLifted});
  axis("pose", {kRight, kMirrored});
  return experiment;
}

/// The options that a run and the trials share.
std::string shared_options(const FootageExperimentOptions& options) {
  std::string line = words_of(options.setup.footage);
  const auto add = [&line](const char* option, const std::string& value) {
    line.append(" ").append(option).append(" ").append(shell_word(value));
  };
  const FootageSetup& setup = options.setup;
  if (!setup.body.empty()) add("--body", setup.body.string());
  if (!setup.field.empty()) add("--field", setup.field.string());
  if (!setup.at.empty()) add("--at", setup.at);
  for (const std::filesystem::path& file : setup.parameters.files) add("--params", file.string());
  for (const std::string& assignment : setup.parameters.assignments) add("--set", assignment);
  add("--seed", std::to_string(setup.seed));
  if (!setup.behaviors.empty()) add("--behaviors", fmt::format("{}", fmt::join(setup.behaviors, ",")));
  if (!setup.scripts.empty()) add("--scripts", setup.scripts.string());
  return line;
}

std::string command_of(const FootageExperimentOptions& options) {
  std::string line = "reorient experiment footage";
  for (const std::string& source : options.sources) line.append(" ").append(shell_word(source));
  return line + shared_options(options) +
         fmt::format(" --starts {} --learn {} --watch {} --off-degrees {}", options.trials.starts, options.trials.learn,
                     options.trials.watch, options.off_degrees);
}

/// The command that shows one trial.
std::string trial_command(const FootageExperimentOptions& options, const std::string& source,
                          const FootageTrials::Start& start, const FootageCase& one) {
  std::string belief = one.pose;
  if (one.change.turned_by != 0.0 && !one.change.mirrored) belief = fmt::format("{}", options.off_degrees);
  if (one.change.turned_by != 0.0 && one.change.mirrored) belief = fmt::format("mirrored:{}", options.off_degrees);
  return "reorient run --robot footage " + shell_word(source) + shared_options(options) +
         fmt::format(" --belief {} --belief-at {}{}", belief, to_microseconds(start.time),
                     one.change.kind == BeliefChange::Kind::lifted ? " --lifted" : "");
}

/// Differs if the footage, options or scripts differ, so that results are never mixed.
std::filesystem::path usual_folder(const std::vector<std::unique_ptr<FootageTrials>>& footages) {
  Digest digest;
  for (const auto& footage : footages) digest.add(footage->origin());
  return std::filesystem::path("out") / "experiments" / ("footage-" + digest.hex());
}

int run(FootageExperimentOptions options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  const std::filesystem::path root = scripts_root(options.setup.scripts);
  options.trials.turned_by = from_degrees(options.off_degrees);
  if (!options.out.empty()) require_writable_folder(options.out, "--out");
  if (!options.json.empty()) require_writable_file(options.json, "--json");
  if (!options.report.empty()) require_writable_folder(options.report, "--report");
  const ScriptTexts scripts = read_scripts(root);
  FootageResults results;
  std::vector<std::string>& names = results.names;
  for (const std::string& source : options.sources) {
    FootageSetup setup = options.setup;
    setup.source = source;
    setup.scripts = root;
    std::string name = name_of(source);
    if (std::find(names.begin(), names.end(), name) != names.end()) name = source;
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw std::runtime_error("expected different sources, found " + source + " twice");
    names.push_back(std::move(name));
    results.footages.push_back(std::make_unique<FootageTrials>(setup, options.trials, scripts));
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    out << as_line(names[i]) << ": " << results.footages[i]->wall() << '\n';
  const Experiment experiment = experiment_of(options, names);
  results.cases = cases_of(options.trials);
  const auto starts = static_cast<std::size_t>(options.trials.starts);
  const std::size_t of_footage = results.cases.size() * starts;
  // Tasks are numbered from 1: all starts of a case, all cases of a footage.
  struct Trial {
    std::size_t footage, start;
    const FootageCase& one;
  };
  const auto trial_of = [&](int task) {
    const std::size_t index = static_cast<std::size_t>(task - 1), within = index % of_footage;
    return Trial{index / of_footage, within % starts, results.cases[within / starts]};
  };
  const auto origin_of = [&](int task) {
    return Origin{{"footage and options", fmt::format("{:016x}", results.footages[trial_of(task).footage]->origin())}};
  };
  const std::filesystem::path folder = options.out.empty() ? usual_folder(results.footages) : options.out;
  require_writable_folder(folder, "--out");
  const TaskResults tasks(folder);
  std::vector<int> missing;
  for (int task = 1; task <= static_cast<int>(results.footages.size() * of_footage); ++task) {
    if (!tasks.read(task, origin_of(task))) missing.push_back(task);
  }
  out.flush();  // otherwise each process would write the buffered output
  Countdown countdown(err, missing.size());
  std::string mistake;
  run_in_processes(
      missing, options.jobs,
      [&](int task) {
        const Trial trial = trial_of(task);
        tasks.write(task, origin_of(task), results.footages[trial.footage]->run(trial.start, trial.one));
      },
      [&](const TaskEnd& end) {
        countdown.count();
        if (end.is_done()) return true;
        mistake = fmt::format("trial {}: {}", end.number,
                              end.signal == 0 ? end.mistake : "crashed with signal " + std::to_string(end.signal));
        return false;
      },
      [] { return Interruption::signal() != 0; });
  countdown.clear();
  if (!mistake.empty()) throw std::runtime_error(mistake);
  if (Interruption::signal() != 0) {
    err << fmt::format("reorient: finished trials are in {}; the same command continues with the others\n",
                       as_line(folder.string()));
    return exit_code_of(Interruption::signal());
  }
  int task = 1;
  for (const std::string& name : names) {
    for (const FootageCase& one : results.cases) {
      CellResults& cell = results.cells.emplace_back();
      cell.choices = {name, one.start, one.pose};
      for (std::size_t start = 0; start < starts; ++start, ++task)
        cell.trials.push_back(tasks.read(task, origin_of(task)).value());
      cell.row = row_of(cell.trials);
    }
  }
  out << '\n' << as_line(experiment.title) << "\n\n";
  print_rows(experiment, results.cells, out);
  const auto shown_by = [&](std::size_t footage, std::size_t start, const FootageCase& one) {
    return trial_command(options, options.sources[footage], results.footages[footage]->starts()[start], one);
  };
  print_footage_results(results, options.trials, shown_by, out);
  std::vector<std::string> failures;
  if (!options.json.empty())
    try_to_write(failures, [&] { write_whole_file(options.json, rows_as_json(experiment, results.cells)); });
  if (!options.report.empty()) {
    const std::string command = command_of(options);
    Report report{experiment, std::move(results.cells), provenance_here(command), [&](int number) {
                    const Trial trial = trial_of(number);
                    return shown_by(trial.footage, trial.start, trial.one);
                  }};
    for (std::string& failure : write_report(report, options.report)) failures.push_back(std::move(failure));
    out << "\nreport: " << as_line((options.report / "index.html").string()) << "\n";
  }
  for (const std::string& failure : failures) print_error(err, failure);
  return failures.empty() ? kSuccess : kBadInput;
}

}  // namespace

Subcommand add_footage_experiment(CLI::App& experiment) {
  constexpr int kMostStarts = 10'000, kMostJobs = 1'000;
  const auto options = std::make_shared<FootageExperimentOptions>();
  constexpr const char* const kTrials = "Trials";
  CLI::App* const parser =
      experiment.add_subcommand("footage", "run trials on recorded images, with and without room awareness");
  set_examples(*parser, {{"reorient experiment footage images --starts 50", "50 starts of each case"},
                         {"reorient experiment footage images --report out/report", "with a page of figures"}});
  parser->add_option("source", options->sources, "folders of images, tables (.csv) or videos")
      ->type_name("SOURCE")
      ->required()
      ->check(check_not_empty);
  parser->add_option("--starts", options->trials.starts, "number of start times in each footage")
      ->type_name("N")
      ->group(kTrials)
      ->check(CLI::Range(1, kMostStarts))
      ->capture_default_str();
  parser->add_option("--learn", options->trials.learn, "time of learning before the first start, s")
      ->type_name("SECONDS")
      ->group(kTrials)
      ->check(check_moment)
      ->capture_default_str();
  parser
      ->add_option("--watch", options->trials.watch, "time after each start in which a mirrored pose must be found, s")
      ->type_name("SECONDS")
      ->group(kTrials)
      ->check(check_seconds)
      ->capture_default_str();
  parser->add_option("--off-degrees", options->off_degrees, "error of the rotation in the trials 'told, off'")
      ->type_name("N")
      ->group(kTrials)
      ->check(CLI::Range(-90.0, 90.0))
      ->capture_default_str();
  parser->add_option("--seed", options->setup.seed, "seed of the engine")
      ->type_name("N")
      ->group(kTrials)
      ->check(check_seed)
      ->capture_default_str();
  parser->add_option("--jobs", options->jobs, "number of processes")
      ->type_name("N")
      ->group(kTrials)
      ->check(CLI::Range(1, kMostJobs))
      ->capture_default_str();
  parser->add_option("--at", options->setup.at, "pose of the robot if only its rotation was recorded: m, m, degrees")
      ->type_name("X,Y,DEGREES")
      ->group(kFootageGroup)
      ->check(check_not_empty);
  add_footage_options(*parser, options->setup.footage);
  add_body_options(*parser, options->setup.body, options->setup.field);
  parser->add_option("--behaviors", options->setup.behaviors, "behaviors to run (default: all that can run)")
      ->type_name("A,B,...")
      ->group(kParameterGroup)
      ->delimiter(',')
      ->check(check_not_empty);
  add_parameter_options(*parser, options->setup.parameters);
  add_scripts_option(*parser, options->setup.scripts);
  parser->add_option("--out", options->out, "folder for the results (default: a new one in out/experiments)")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  parser->add_option("--json", options->json, "write the table as JSON")
      ->type_name("FILE")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  parser->add_option("--report", options->report, "write a page with tables and figures into this folder")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty);
  return {parser, [options](std::ostream& out, std::ostream& err) { return run(*options, out, err); }};
}

}  // namespace reorient
