// SPDX-License-Identifier: MIT
// `reorient experiment`: runs many trials of an experiment file in several processes and prints their results.
#include <array>
#include <cstring>
#include <memory>
#include <numeric>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "geometry/image.h"
#include "program/commands/compare_command.h"
#include "program/commands/field_features_experiment_command.h"
#include "program/commands/field_images_experiment_command.h"
#include "program/commands/footage_experiment_command.h"
#include "program/commands/tables_command.h"
#include "program/experiment/countdown.h"
#include "program/experiment/outputs/report_folder.h"
#include "program/experiment/outputs/rows_report.h"
#include "program/experiment/session.h"
#include "program/experiment/trial_runner.h"
#include "program/experiment/worker_pool.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/program.h"
#include "program/run/run_scenario.h"
#include "program/safe_output.h"
#include "program/shell_word.h"
#include "program/subcommand.h"
#include "workbench/experiments/trial/trial_observer.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

struct ExperimentOptions : SessionOptions {
  int jobs = 1;
  std::string tasks;  ///< a list; empty: all
  bool plan = false;
  bool resume = false;
  int trial = 0;                   ///< the trial to show; 0: none
  std::filesystem::path pictures;  ///< of that trial
  std::filesystem::path json;
  std::filesystem::path report;
};

/// The command line with everything that determines the results, quoted for a shell.
std::string command_of(const ExperimentOptions& options) {
  std::string line = "reorient experiment " + shell_word(options.experiment);
  const auto add = [&line](const char* option, const std::string& value) {
    line.append(" ").append(option).append(" ").append(shell_word(value));
  };
  if (options.trials) add("--trials", std::to_string(*options.trials));
  if (options.width) add("--width", std::to_string(*options.width));
  add("--seed", std::to_string(options.seed));
  for (const std::string& room : options.rooms) add("--room", room);
  for (const std::string& mode : options.modes) add("--mode", mode);
  for (const std::string& motion : options.motions) add("--motion", motion);
  for (const std::string& light : options.lights) add("--light", light);
  for (const std::string& choice : options.only) add("--only", choice);
  for (const std::filesystem::path& file : options.parameters.files) add("--params", file.string());
  for (const std::string& assignment : options.parameters.assignments) add("--set", assignment);
  if (!options.scripts.empty()) add("--scripts", options.scripts.string());
  return line;
}

/// The command that runs one task.
std::string task_command(const ExperimentOptions& options, const Session& session, int task) {
  return command_of(options) + " --out " + shell_word(session.folder().string()) + " --task " + std::to_string(task);
}

Report report_of(const ExperimentOptions& options, const Session& session, std::vector<CellResults> cells) {
  std::string command = command_of(options);
  if (!options.out.empty()) command += " --out " + shell_word(options.out.string());
  command += " --report " + shell_word(options.report.string());
  return {session.experiment(), std::move(cells), provenance_here(command), [options](int task) {
            return fmt::format("{} --trial {} --pictures out/trial-{}", command_of(options), task, task);
          }};
}

struct RunOutcome {
  int crashed = 0;
  std::string mistake;  ///< that ended the experiment
};

RunOutcome run_tasks(const ExperimentOptions& options, Session& session, const std::vector<int>& tasks,
                     std::ostream& out, std::ostream& err) {
  out.flush();  // otherwise each process would write the buffered output
  RunOutcome outcome;
  Countdown countdown(err, tasks.size());
  run_in_processes(
      tasks, options.jobs, [&session](int task) { session.run(task); },
      [&](const TaskEnd& end) {
        countdown.count();
        if (end.is_done()) return true;
        countdown.clear();
        if (end.signal == 0) {
          outcome.mistake = fmt::format("task {}, {}: {}", end.number, session.name_of(end.number), end.mistake);
          return false;
        }
        ++outcome.crashed;
        err << fmt::format("reorient: task {}, {}: crashed ({}); this runs it again: {}\n", end.number,
                           session.name_of(end.number), strsignal(end.signal),
                           as_line(task_command(options, session, end.number)));
        return true;
      },
      [] { return Interruption::signal() != 0; });
  return outcome;
}

void require_different_files(const ExperimentOptions& options, const Session& session) {
  NamedFiles files;
  files.reads_scripts(session.scripts());
  files.reads(options.experiment, "the experiment");
  for (const std::string& room : options.rooms) files.reads(room, "--room");
  for (const std::filesystem::path& file : parameter_files_of(options.parameters)) files.reads(file, "--params");
  files.writes(options.json, "--json");
}

std::string seconds_text(const std::optional<double>& time) { return time ? fmt::format("{:.1f} s", *time) : "never"; }

std::string verdict_of(const TrialResult& result, const Measurement& measurement) {
  if (!result.started) return "the trial never reached the state '" + as_line(measurement.from) + "'";
  if (result.correct_at_start)
    return result.right_after ? "the belief was right at first, and stayed right"
                              : "the belief was right at first, and became wrong";
  return fmt::format(
      "the belief was wrong at first; right and stayed right after: {}; corrected by a command after: {}",
      seconds_text(result.right_after), seconds_text(result.corrected_after));
}

/// Runs one trial and shows it as `reorient run` does; its result is not stored.
int show_trial(const ExperimentOptions& options, const Session& session, std::ostream& out, std::ostream& err) {
  const int count = static_cast<int>(session.tasks().size());
  if (options.trial > count)
    throw std::runtime_error(fmt::format("unknown trial {} (expected 1 to {})", options.trial, count));
  const Condition condition = session.condition_of(options.trial);
  RunOptions run;
  RoomCache rooms;
  static_cast<SimulationOptions&>(run) =
      prepared_options_of(condition, session.seed_of(options.trial), session.scripts(), rooms);
  run.pictures = !options.pictures.empty();
  run.out = options.pictures;
  out << as_line(session.name_of(options.trial)) << "\n";
  TrialObserver observer(condition.measurement);
  return run_scenario(run,
                      {{&observer},
                       [&observer] { return observer.is_over(); },
                       [&](RunSummary& summary) {
                         summary.succeeded = observer.result().started && !observer.result().failed();
                         summary.verdict = verdict_of(observer.result(), condition.measurement);
                       }},
                      out, err);
}

int run_experiment(const ExperimentOptions& options, std::ostream& out, std::ostream& err) {
  if (options.experiment.empty())
    throw std::runtime_error(
        "expected an experiment: a file, or a name in assets/experiments (see reorient experiment --help)");
  Session session(options);
  if (options.trial > 0) return show_trial(options, session, out, err);
  const int count = static_cast<int>(session.tasks().size());
  std::vector<int> wanted(static_cast<std::size_t>(count));
  std::iota(wanted.begin(), wanted.end(), 1);
  if (!options.tasks.empty()) wanted = numbers_in(options.tasks, count);
  if (options.plan) {
    for (const int task : wanted) out << as_line(task_command(options, session, task)) << '\n';
    return kSuccess;
  }
  const Interruption interruption;
  require_different_files(options, session);
  require_writable_folder(session.folder(), "--out");
  if (!options.json.empty()) require_writable_file(options.json, "--json");
  if (!options.report.empty()) require_writable_folder(options.report, "--report");
  const std::vector<int> missing = session.missing(wanted);
  if (options.tasks.empty() && !options.resume && missing.size() < wanted.size())
    throw std::runtime_error(fmt::format(
        "{} contains {} of {} results already; --resume {}, another --out starts again", session.folder().string(),
        wanted.size() - missing.size(), wanted.size(), missing.empty() ? "prints them" : "continues with the others"));
  const RunOutcome outcome = run_tasks(options, session, missing, out, err);
  if (!outcome.mistake.empty()) throw std::runtime_error(outcome.mistake + "; when it is fixed, --resume continues");
  if (Interruption::signal() != 0) {
    err << fmt::format("reorient: {} of {} results are in {}; --resume continues\n",
                       wanted.size() - session.missing(wanted).size(), wanted.size(),
                       as_line(session.folder().string()));
    return exit_code_of(Interruption::signal());
  }
  if (outcome.crashed > 0) {
    err << fmt::format("reorient: {} of {} trials crashed; the others are in {}\n", outcome.crashed, wanted.size(),
                       as_line(session.folder().string()));
    return kWrong;
  }
  if (!options.tasks.empty()) return kSuccess;  // the rest is run elsewhere
  std::vector<CellResults> cells = session.cell_results();
  out << as_line(session.experiment().title) << "\n\n";
  print_rows(session.experiment(), cells, out);
  std::vector<std::string> failures;
  if (!options.json.empty())
    try_to_write(failures, [&] { write_whole_file(options.json, rows_as_json(session.experiment(), cells)); });
  if (!options.report.empty()) {
    for (std::string& failure : write_report(report_of(options, session, std::move(cells)), options.report))
      failures.push_back(std::move(failure));
    out << "\nreport: " << as_line((options.report / "index.html").string()) << "\n";
  }
  for (const std::string& failure : failures) print_error(err, failure);
  return failures.empty() ? kSuccess : kBadInput;
}

}  // namespace

Subcommand add_experiment(CLI::App& program) {
  constexpr int kMostTrials = 100'000, kMostJobs = 1'000, kMostTasks = 1'000'000;
  constexpr const char* const kConditions = "Conditions";
  constexpr const char* const kTrials = "Trials";
  const auto options = std::make_shared<ExperimentOptions>();
  CLI::App* const parser = program.add_subcommand("experiment", "run many trials and print their results");
  parser->fallthrough();
  set_examples(*parser, {{"reorient experiment mirrored_placement --trials 10", "run 10 trials of each cell"},
                         {"reorient experiment disturbances --light hard --jobs 4", "one light, in four processes"},
                         {"reorient experiment mirrored_placement --trial 17", "show one trial"}});
  parser->add_option("experiment", options->experiment, "experiment: a file, or the name of one in assets/experiments")
      ->type_name("EXPERIMENT")
      ->check(check_not_empty);
  const std::array others = {add_compare(*parser), add_tables(*parser), add_footage_experiment(*parser),
                             add_field_images_experiment(*parser), add_field_features_experiment(*parser)};
  parser->add_option("--trials", options->trials, "number of trials in each cell (default: the file's)")
      ->type_name("N")
      ->group(kTrials)
      ->check(CLI::Range(1, kMostTrials));
  parser->add_option("--seed", options->seed, "seed of the first trial of each cell; then the next numbers")
      ->type_name("N")
      ->group(kTrials)
      ->check(check_seed)
      ->capture_default_str();
  parser->add_option("--width", options->width, "width of the camera image in pixels (default: the file's)")
      ->type_name("N")
      ->group(kTrials)
      ->check(CLI::IsMember(kImageWidths));
  const auto add_list = [&](const char* names, const char* placeholder, std::vector<std::string>& list,
                            const char* text) {
    parser->add_option(names, list, text)->type_name(placeholder)->group(kConditions)->check(check_not_empty);
  };
  add_list("--rooms,--room", "FILE", options->rooms, "panoramas instead of the file's rooms; hall: the built-in hall");
  add_list("--mode", "CHOICE", options->modes, "choices of the axis 'mode', or files of conditions (default: all)");
  add_list("--motion", "CHOICE", options->motions, "the same for the axis 'motion'");
  add_list("--light", "CHOICE", options->lights, "the same for the axis 'light'");
  add_list("--only", "AXIS=CHOICE", options->only, "the same for any axis");
  add_parameter_options(*parser, options->parameters);
  add_scripts_option(*parser, options->scripts);
  parser->add_option("--jobs", options->jobs, "number of processes")
      ->type_name("N")
      ->group(kTrials)
      ->check(CLI::Range(1, kMostJobs))
      ->capture_default_str();
  parser->add_option("--out", options->out, "folder for the results (default: one for each plan in out/experiments)")
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
  CLI::Option* const plan =
      parser->add_flag("--plan", options->plan, "print the command of each trial and run none")->group(kTrials);
  parser->add_option("--task,--tasks", options->tasks, "run these trials only, as in 17 or 1-64")
      ->type_name("LIST")
      ->group(kTrials)
      ->check(check_not_empty);
  CLI::Option* const trial =
      parser->add_option("--trial", options->trial, "run this trial only, and show it as 'reorient run' does")
          ->type_name("N")
          ->group(kTrials)
          ->check(CLI::Range(1, kMostTasks))
          ->excludes(plan);
  parser->add_option("--pictures", options->pictures, "folder for the pictures of --trial")
      ->type_name("FOLDER")
      ->group(kOutputGroup)
      ->check(check_not_empty)
      ->needs(trial);
  parser
      ->add_flag("--resume", options->resume, "continue where an earlier run ended; without --task, print all results")
      ->group(kTrials)
      ->excludes(plan);
  return {parser, [options, others](std::ostream& out, std::ostream& err) {
            for (const Subcommand& other : others) {
              if (other.parser->parsed()) return other.run(out, err);
            }
            return run_experiment(*options, out, err);
          }};
}

}  // namespace reorient
