#include "program/commands/footage_experiment_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "engine/record/digest.h"
#include "program/experiment/countdown.h"
#include "program/experiment/outputs/report_folder.h"
#include "program/experiment/outputs/rows_report.h"
#include "program/experiment/outputs/text_table.h"
#include "program/experiment/task_results.h"
#include "program/experiment/worker_pool.h"
#include "program/footage/footage_trials.h"
#include "program/interruption.h"
#include "program/program.h"
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

/// As the tables of other experiments have it.
Experiment experiment_of(const FootageExperimentOptions& options, const std::vector<std::string>& names) {
  Experiment experiment;
  experiment.name = "footage";
  experiment.title = "Footage: the pose is set right or mirrored at many moments";
  experiment.description = fmt::format(
      "Each trial goes on from a robot that lived through everything before with the recorded poses. Told: somebody "
      "tells it the pose; told, off: the same, {:g} degrees off; lifted: it is lifted and put down with the belief "
      "that it had. Watched for {:g} s.",
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

/// Why a mirrored pose was not found, or a right one lost: what the room said meanwhile.
std::string cause_of(const TrialResult& result) {
  std::map<RoomStatus, int> statuses;
  double most = -1e9, least = 1e9;
  for (const ConfidenceSample& sample : result.confidences) {
    ++statuses[sample.status];
    most = std::max(most, sample.evidence);
    least = std::min(least, sample.evidence);
  }
  if (statuses.empty()) return "no image was seen";
  std::string text;
  for (const auto& [status, count] : statuses)
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", to_string(status),
                        100.0 * count / static_cast<double>(result.confidences.size()));
  text = fmt::format("evidence {:.1f} to {:.1f}; the room was {}", least, most, text);
  return text;
}

/// What a run and many trials have in common.
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

/// As a number on the command line has it.
double to_microseconds(double seconds) { return std::round(seconds * 1e6) / 1e6; }

/// What shows one trial.
std::string trial_command(const FootageExperimentOptions& options, const std::string& source,
                          const FootageTrials::Start& start, const FootageCase& one) {
  std::string belief = one.pose;
  if (one.change.turned_by != 0.0 && !one.change.mirrored) belief = fmt::format("{}", options.off_degrees);
  if (one.change.turned_by != 0.0 && one.change.mirrored) belief = fmt::format("mirrored:{}", options.off_degrees);
  return "reorient run --robot footage " + shell_word(source) + shared_options(options) +
         fmt::format(" --belief {} --belief-at {}{}", belief, to_microseconds(start.time),
                     one.change.kind == BeliefChange::Kind::lifted ? " --lifted" : "");
}

bool has_failed(const TrialResult& result, const FootageCase& one) {
  return one.change.mirrored ? result.failed() : result.false_flips > 0;
}

std::string what_went_wrong(const TrialResult& result, const FootageCase& one, const FootageTrialOptions& options) {
  if (!one.change.mirrored) return "flipped";
  if (!result.mended_after) return "not found";
  return fmt::format("found after {:.1f} s, {}", *result.mended_after,
                     *result.mended_after > options.watch ? "too late" : "but wrong again later");
}

void print_failures(const FootageExperimentOptions& options, const std::vector<CellResults>& cells,
                    const std::vector<FootageCase>& cases, const std::vector<std::unique_ptr<FootageTrials>>& footages,
                    std::ostream& out) {
  bool any = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const FootageCase& one = cases[i % cases.size()];
    const std::size_t footage = i / cases.size();
    bool any_here = false;
    for (const TrialResult& result : cells[i].trials) {
      if (!has_failed(result, one)) continue;
      if (!std::exchange(any, true))
        out << "\nTrials that went wrong. A command shows the first of its row; the others differ in --belief-at:\n";
      const FootageTrials::Start& start = footages[footage]->starts()[result.seed - 1];
      if (!std::exchange(any_here, true))
        out << fmt::format("{}, {}, {}:\n    {}\n", as_line(cells[i].choices[0]), one.start, one.pose,
                           trial_command(options, options.sources[footage], start, one));
      out << fmt::format("  {} s, image {}: {}; {}\n", to_microseconds(start.time), as_line(start.image),
                         what_went_wrong(result, one, options.trials), cause_of(result));
    }
  }
}

/// Trials in which nothing could be found, since the robot still learned the room.
void print_unlearned(const std::vector<std::string>& names, const std::vector<std::unique_ptr<FootageTrials>>& footages,
                     std::ostream& out) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& starts = footages[i]->starts();
    const std::optional<double> learned = footages[i]->room_learned_at();
    const auto early =
        std::count_if(starts.begin(), starts.end(), [&](const auto& one) { return !learned || one.time <= *learned; });
    if (early == 0) continue;
    out << fmt::format(
        "\n{}: {} of {} starts come before the room was learned{}\n", as_line(names[i]), early, starts.size(),
        learned ? fmt::format(" (at {:.1f} s); --learn {:.0f} leaves them out", *learned, std::floor(*learned) + 1.0)
                : std::string(", which never happened"));
  }
}

/// The answer in one line.
void print_answer(const std::vector<CellResults>& cells, const std::vector<FootageCase>& cases, std::ostream& out) {
  int mirrored = 0, found = 0, right = 0, flipped = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const FootageCase& one = cases[i % cases.size()];
    for (const TrialResult& result : cells[i].trials) {
      const bool failed = has_failed(result, one);
      (one.change.mirrored ? mirrored : right) += 1;
      if (one.change.mirrored && !failed) ++found;
      if (!one.change.mirrored && failed) ++flipped;
    }
  }
  out << fmt::format("\n{} of {} mirrored poses were found ({:.1f} %); {} of {} right poses were flipped ({:.1f} %)\n",
                     found, mirrored, 100.0 * found / mirrored, flipped, right, 100.0 * flipped / right);
}

/// The same times, counted in images: what is left of them where images come seldom.
void print_images(const std::vector<CellResults>& cells, const std::vector<FootageCase>& cases,
                  const std::vector<std::unique_ptr<FootageTrials>>& footages, std::ostream& out) {
  TextTable lines{{"room", "start", "found", "images until then: median", "p90", "most"}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cases[i % cases.size()].change.mirrored) continue;
    std::vector<int> images;
    for (const TrialResult& result : cells[i].trials) {
      if (result.right_after)
        images.push_back(footages[i / cases.size()]->images_within(result.seed - 1,
                                                                   result.mended_after.value_or(*result.right_after)));
    }
    std::sort(images.begin(), images.end());
    const auto quantile = [&](double share) {
      if (images.empty()) return std::string("-");
      return std::to_string(
          images[static_cast<std::size_t>(std::lround(share * static_cast<double>(images.size() - 1)))]);
    };
    lines.push_back({as_line(cells[i].choices[0]), cells[i].choices[1],
                     fmt::format("{} of {}", images.size(), cells[i].trials.size()), quantile(0.5), quantile(0.9),
                     quantile(1.0)});
  }
  out << '\n';
  print_table(lines, 2, out);
}

/// Whether the next trial begins before one is over, on the average.
bool have_common_images(const std::vector<std::unique_ptr<FootageTrials>>& footages,
                        const FootageTrialOptions& options) {
  return std::any_of(footages.begin(), footages.end(), [&](const std::unique_ptr<FootageTrials>& footage) {
    const auto& starts = footage->starts();
    return starts.back().time - starts.front().time < options.watch * static_cast<double>(starts.size() - 1);
  });
}

/// Another one where anything is another: what is there is of the same footage, options and scripts.
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
  std::vector<std::string> names;
  std::vector<std::unique_ptr<FootageTrials>> footages;
  for (const std::string& source : options.sources) {
    FootageSetup setup = options.setup;
    setup.source = source;
    setup.scripts = root;
    std::string name = name_of(source);
    if (std::find(names.begin(), names.end(), name) != names.end()) name = source;
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw std::runtime_error("the footage " + source + " is named twice");
    names.push_back(std::move(name));
    footages.push_back(std::make_unique<FootageTrials>(setup, options.trials, scripts));
  }
  for (std::size_t i = 0; i < names.size(); ++i) out << as_line(names[i]) << ": " << footages[i]->wall() << '\n';
  const Experiment experiment = experiment_of(options, names);
  const std::vector<FootageCase> cases = cases_of(options.trials);
  const auto starts = static_cast<std::size_t>(options.trials.starts);
  const std::size_t of_footage = cases.size() * starts;
  const std::filesystem::path folder = options.out.empty() ? usual_folder(footages) : options.out;
  require_writable_folder(folder, "--out");
  const TaskResults results(folder);
  const auto origin_of = [&](int task) { return footages[static_cast<std::size_t>(task - 1) / of_footage]->origin(); };
  std::vector<int> missing;
  for (int task = 1; task <= static_cast<int>(footages.size() * of_footage); ++task) {
    if (!results.read(task, origin_of(task))) missing.push_back(task);
  }
  out.flush();  // what is still to be written must not be written by each process
  Countdown countdown(err, missing.size());
  std::string mistake;
  run_in_processes(
      missing, options.jobs,
      [&](int task) {
        const std::size_t index = static_cast<std::size_t>(task - 1), within = index % of_footage;
        results.write(task, origin_of(task),
                      footages[index / of_footage]->run(within % starts, cases[within / starts]));
      },
      [&](const TaskEnd& end) {
        countdown.count();
        if (end.is_done()) return true;
        mistake = fmt::format("trial {}: {}", end.number,
                              end.signal == 0 ? end.mistake : "it crashed with signal " + std::to_string(end.signal));
        return false;
      },
      [] { return Interruption::signal() != 0; });
  countdown.clear();
  if (!mistake.empty()) throw std::runtime_error(mistake);
  if (Interruption::signal() != 0) {
    err << fmt::format("reorient: the trials that are done are in {}; the same command goes on with the others\n",
                       folder.string());
    return exit_code_of(Interruption::signal());
  }
  std::vector<CellResults> cells;
  int task = 1;
  for (const std::string& name : names) {
    for (const FootageCase& one : cases) {
      CellResults& cell = cells.emplace_back();
      cell.choices = {name, one.start, one.pose};
      for (std::size_t start = 0; start < starts; ++start, ++task)
        cell.trials.push_back(results.read(task, origin_of(task)).value());
      cell.row = row_of(cell.trials);
    }
  }
  out << '\n' << experiment.title << "\n\n";
  print_rows(experiment, cells, out);
  print_images(cells, cases, footages, out);
  print_failures(options, cells, cases, footages, out);
  print_unlearned(names, footages, out);
  if (options.trials.starts > 1 && have_common_images(footages, options.trials))
    out << "\nTrials follow each other so closely that they share images: the intervals are narrower than they should "
           "be.\n";
  print_answer(cells, cases, out);
  std::vector<std::string> failures;
  if (!options.json.empty())
    try_to_write(failures, [&] { write_whole_file(options.json, rows_as_json(experiment, cells)); });
  if (!options.report.empty()) {
    const std::string command = command_of(options);
    Report report{experiment, std::move(cells), provenance_here(command), [&](int number) {
                    const std::size_t index = static_cast<std::size_t>(number - 1), within = index % of_footage;
                    return trial_command(options, options.sources[index / of_footage],
                                         footages[index / of_footage]->starts()[within % starts],
                                         cases[within / starts]);
                  }};
    for (std::string& failure : write_report(report, options.report)) failures.push_back(std::move(failure));
    out << "\nreport: " << (options.report / "index.html").string() << "\n";
  }
  for (const std::string& failure : failures) err << "reorient: " << failure << "\n";
  return failures.empty() ? kSuccess : kBadInput;
}

}  // namespace

Subcommand add_footage_experiment(CLI::App& experiment) {
  constexpr int kMostStarts = 10'000, kMostJobs = 1'000;
  const auto options = std::make_shared<FootageExperimentOptions>();
  CLI::App* const parser =
      experiment.add_subcommand("footage", "would room awareness have helped? Trials on images that somebody recorded");
  parser->add_option("source", options->sources, "folders of images, tables (.csv), videos")
      ->required()
      ->check(check_not_empty);
  add_footage_options(*parser, options->setup.footage);
  add_body_options(*parser, options->setup.body, options->setup.field);
  parser
      ->add_option("--at", options->setup.at, "where the robot stands, X,Y,DEGREES, if only its rotation was recorded")
      ->check(check_not_empty);
  parser->add_option("--behaviors", options->setup.behaviors, "which behaviors run, as in A,B")
      ->delimiter(',')
      ->check(check_not_empty);
  parser->add_option("--starts", options->trials.starts, "at how many moments of each footage")
      ->check(CLI::Range(1, kMostStarts))
      ->capture_default_str();
  parser->add_option("--learn", options->trials.learn, "s of the footage before the first of them")
      ->check(check_moment)
      ->capture_default_str();
  parser->add_option("--watch", options->trials.watch, "s after each, in which a mirrored pose is to be found")
      ->check(check_seconds)
      ->capture_default_str();
  parser->add_option("--off-degrees", options->off_degrees, "how wrong the rotation is in the trials 'told, off'")
      ->check(CLI::Range(-90.0, 90.0))
      ->capture_default_str();
  parser->add_option("--seed", options->setup.seed, "of the engine")->check(check_seed)->capture_default_str();
  add_parameter_options(*parser, options->setup.parameters);
  add_scripts_option(*parser, options->setup.scripts);
  parser->add_option("--jobs", options->jobs, "how many processes share the trials")
      ->check(CLI::Range(1, kMostJobs))
      ->capture_default_str();
  parser->add_option("--out", options->out, "folder for the results (default: one of its own in out/experiments)")
      ->check(check_not_empty);
  parser->add_option("--json", options->json, "write the table into this file, for programs")->check(check_not_empty);
  parser->add_option("--report", options->report, "write a page with tables and figures into this folder")
      ->check(check_not_empty);
  return {parser, [options](std::ostream& out, std::ostream& err) { return run(*options, out, err); }};
}

}  // namespace reorient
