// SPDX-License-Identifier: MIT
#include "program/experiment/session.h"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "engine/script/script_texts.h"
#include "program/experiment/outputs/rows_report.h"
#include "program/experiment/trial_runner.h"
#include "program/former_names.h"
#include "program/run/venue.h"
#include "workbench/experiments/condition/experiment_file.h"
#include "workbench/files/home.h"
#include "workbench/files/input_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

constexpr std::string_view kTomlFiles[] = {".toml"};

/// A file of the user, or a shipped file by its name; nothing if neither exists.
std::optional<std::filesystem::path> found_file(std::string_view folder, const std::string& named) {
  std::filesystem::path file = asset_file(folder, named, kTomlFiles);
  std::error_code error;
  return std::filesystem::exists(file, error) ? std::optional(std::move(file)) : std::nullopt;
}

/// `kind`: "experiment"; the folder of its assets has the plural name.
std::filesystem::path named_file(const std::string& kind, const std::string& named) {
  const std::string folder = kind + "s";
  if (std::optional<std::filesystem::path> file = found_file(folder, named)) return *std::move(file);
  throw std::runtime_error("unknown " + kind + " '" + as_line(named) + "'" +
                           did_you_mean(named, asset_names(folder, kTomlFiles)) +
                           "; expected a file, or a name in assets/" + folder);
}

ConditionPatch named_condition(const std::string& named) { return read_condition(named_file("condition", named)); }

/// A choice that the axis does not have may be a condition file, shipped or the user's.
AxisChoice choice_from_file(const Axis& axis, const std::string& named) {
  if (const std::optional<std::filesystem::path> file = found_file("conditions", named))
    return {file->stem().string(), read_condition(*file)};
  std::vector<std::string> known = asset_names("conditions", kTomlFiles);
  for (const AxisChoice& choice : axis.choices) known.push_back(choice.name);
  throw std::runtime_error("axis " + as_line(axis.name) + ": unknown choice '" + as_line(named) + "'" +
                           did_you_mean(named, known) + "; expected a choice or a condition file");
}

void choose_requested(const SessionOptions& options, Experiment& experiment) {
  std::map<std::string, std::vector<std::string>> chosen;
  if (!options.modes.empty()) chosen["mode"] = options.modes;
  if (!options.motions.empty()) chosen["motion"] = options.motions;
  if (!options.lights.empty()) chosen["light"] = options.lights;
  for (const std::string& one : options.only) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == one.size())
      throw std::runtime_error("--only: expected AXIS=CHOICE, found '" + as_line(one) + "'");
    chosen[one.substr(0, equals)].push_back(one.substr(equals + 1));
  }
  for (const auto& [axis, names] : chosen) choose(experiment, axis, names, choice_from_file);
}

/// The experiment with the changes of the command line.
Experiment wanted_experiment(const SessionOptions& options) {
  std::optional<std::filesystem::path> file = found_file("experiments", options.experiment);
  if (!file) file = named_file("experiment", present_name(options.experiment));
  Experiment experiment = read_experiment(*file, named_condition);
  if (options.trials) experiment.trials = *options.trials;
  choose_requested(options, experiment);
  if (options.rooms.empty()) return experiment;
  Axis axis;
  axis.name = "room";
  for (const std::string& room : options.rooms) {
    const auto is_called = [](const std::string& name) {
      return [&name](const AxisChoice& choice) { return choice.name == name; };
    };
    std::string name = std::filesystem::path(room).stem().string();
    if (std::any_of(axis.choices.begin(), axis.choices.end(), is_called(name))) name = room;
    if (std::any_of(axis.choices.begin(), axis.choices.end(), is_called(name)))
      throw std::runtime_error("--rooms: expected different rooms, found " + as_line(room) + " twice");
    axis.choices.push_back({name, {}});
    axis.choices.back().patch.room = room == kHall ? "" : room;
  }
  std::erase_if(experiment.axes, [](const Axis& one) { return one.name == "room"; });
  experiment.axes.insert(experiment.axes.begin(), std::move(axis));
  return experiment;
}

/// Digests of files; each file is read once.
class FileHashes {
 public:
  /// Throws std::runtime_error with one line if the file cannot be read.
  std::uint64_t of(const std::filesystem::path& file) {
    const auto known = hashes_.find(file);
    if (known != hashes_.end()) return known->second;
    constexpr std::uintmax_t kLargest = std::uintmax_t{256} << 20;  // bytes, as of a panorama
    try {
      return hashes_[file] = content_hash(read_input(file, "a file", kLargest));
    } catch (const std::runtime_error& reason) {
      throw std::runtime_error(as_line(file.string() + ": " + reason.what()));
    }
  }

 private:
  std::map<std::filesystem::path, std::uint64_t> hashes_;
};

}  // namespace

Session::Session(const SessionOptions& options)
    : scripts_(scripts_root(options.scripts)),
      experiment_(with_usual_choices(wanted_experiment(options))),
      cells_(cells_of(experiment_)),
      tasks_(tasks_of(experiment_, options.seed)),
      folder_(options.out.empty() ? std::filesystem::path("out") / "experiments" / experiment_.name : options.out),
      results_(folder_ / "tasks") {
  const std::vector<ParameterChange> overrides = overrides_of(options.parameters);
  for (Cell& cell : cells_) {
    if (options.width) cell.condition.width = *options.width;
    cell.condition.parameters.insert(cell.condition.parameters.end(), overrides.begin(), overrides.end());
  }
  check_axis_names(experiment_);
  prepare_conditions();
}

std::string Session::name_of(int number) const {
  const Task& task = this->task(number);
  std::string name;
  for (std::size_t i = 0; i < experiment_.axes.size(); ++i)
    name += fmt::format("{} {}, ", as_line(experiment_.axes[i].name), as_line(cells_[task.cell].choices[i]));
  return name + fmt::format("trial {} (seed {})", task.trial + 1, task.seed);
}

Condition Session::condition_of(const Task& task) const {
  return reorient::condition_of(experiment_, cells_[task.cell], task);
}

/// The condition of a task, with one of its cell's alternates in turn.
std::size_t Session::turn_of(const Task& task) const {
  return static_cast<std::size_t>(task.trial) % std::max<std::size_t>(1, experiment_.alternates.size());
}

/// Checks all conditions at the start, because an error hours later would cost time. Stores the origin of each: a
/// digest of everything that determines the results, except for the seed.
void Session::prepare_conditions() {
  scripts_hash_ = content_hash(read_scripts(scripts_));
  FileHashes files;
  origins_.resize(cells_.size());
  for (const Task& task : tasks_) {
    std::vector<std::uint64_t>& origins = origins_[task.cell];
    if (turn_of(task) < origins.size()) continue;  // the same as an earlier one
    const Condition condition = condition_of(task);
    const SimulationOptions options = options_of(condition, task.seed, scripts_);
    const Venue venue = check_trial(condition, task.seed, scripts_);
    const std::vector<ParameterChange> overrides = overrides_of(options.parameters);
    std::string text = fmt::format("{}\n{:x}\n{}", REORIENT_VERSION, scripts_hash_, as_text(condition));
    for (const ParameterChange& change : overrides)
      text.append(change.name).append(" = ").append(change.value).append("\n");
    text += fmt::format("body {:x}\n", files.of(body_file(options.body)));
    text += fmt::format("field {:x}\n", files.of(venue.field));
    if (!venue.room.empty()) text += fmt::format("room {:x}\n", files.of(venue.room));
    origins.push_back(content_hash(text));
  }
}

std::uint64_t Session::origin_of(const Task& task) const {
  return content_hash(fmt::format("{:x}\n{}", origins_[task.cell][turn_of(task)], task.seed));
}

void Session::run(int number) {
  if (result(number)) return;
  const Task& task = this->task(number);
  const TrialResult result = run_trial(condition_of(task), task.seed, scripts_, rooms_);
  // Each trial reads the scripts: an edit since the session began would mix results of different scripts.
  if (content_hash(read_scripts(scripts_)) != scripts_hash_)
    throw std::runtime_error(scripts_.string() + ": expected unchanged scripts during the experiment, found changes");
  results_.write(number, origin_of(task), result);
}

std::optional<TrialResult> Session::result(int number) const { return results_.read(number, origin_of(task(number))); }

std::vector<int> Session::missing(const std::vector<int>& tasks) const {
  std::vector<int> missing;
  for (const int task : tasks) {
    if (!result(task)) missing.push_back(task);
  }
  return missing;
}

std::vector<CellResults> Session::cell_results() const {
  std::vector<CellResults> results;
  results.reserve(cells_.size());
  for (const Cell& cell : cells_) results.push_back({cell.choices, {}, {}});
  for (const Task& task : tasks_) {
    std::optional<TrialResult> found = result(task.number);
    if (!found)
      throw std::runtime_error(results_.file_of(task.number).string() +
                               ": expected the result of a trial, found no file; --resume runs that trial again");
    results[task.cell].trials.push_back(*std::move(found));
  }
  for (CellResults& cell : results) cell.row = row_of(cell.trials);
  return results;
}

}  // namespace reorient
