// SPDX-License-Identifier: MIT
#include "program/experiment/session.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "engine/script/script_texts.h"
#include "program/experiment/compass_parameters.h"
#include "program/experiment/outputs/rows_report.h"
#include "program/experiment/trial_runner.h"
#include "program/former_names.h"
#include "program/run/simulation.h"
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

/// The experiment with the choices of the command line.
Experiment chosen_experiment(const SessionOptions& options) {
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

/// The experiment with the changes of the command line.
Experiment wanted_experiment(const SessionOptions& options) {
  Experiment experiment = chosen_experiment(options);
  experiment.overrides.width = options.width;
  experiment.overrides.parameters = overrides_of(options.parameters);
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
    return hashes_[file] = content_hash(read_named_input(file, "a file", kLargest));
  }

 private:
  std::map<std::filesystem::path, std::uint64_t> hashes_;
};

/// The parameters that a choice of an axis sets by itself or by condition files, not by parameter files.
void append_parameters(const ConditionPatch& patch, std::vector<ParameterChange>& changes) {
  for (const ConditionPatch& first : patch.first) append_parameters(first, changes);
  changes.insert(changes.end(), patch.parameters.begin(), patch.parameters.end());
}

std::vector<ParameterChange> parameters_of(const Axis& axis) {
  std::vector<ParameterChange> changes;
  for (const AxisChoice& choice : axis.choices) append_parameters(choice.patch, changes);
  rename_parameters(changes);
  return changes;
}

/// A behavior that only some of the cells load may be measured, too; then it does nothing in the others.
void require_known_names(const std::vector<Measure>& measures, const LoadedFiles& loaded) {
  const auto refuse = [](const Measure& measure, const std::string& mistake) {
    throw std::runtime_error(
        as_line(measure.said_at + ": measure." + std::string(to_string(measure.type)) + ": " + mistake));
  };
  for (const Measure& measure : measures) {
    if (const std::string mistake = mistake_in_states(measure, loaded.states); !mistake.empty())
      refuse(measure, mistake);
    constexpr std::string_view kAction = "action.";
    const bool is_command = measure.type == MeasureType::granted || measure.type == MeasureType::refused;
    if (!is_command || !measure.name.starts_with(kAction)) continue;
    const std::string action = measure.name.substr(kAction.size());
    if (!loaded.actions.contains(action))
      refuse(measure, "unknown action '" + action + "'" +
                          did_you_mean(action, std::vector<std::string>(loaded.actions.begin(), loaded.actions.end())));
  }
}

/// Otherwise the results would have the names of values that no trial had.
void require_no_axis_sets(const Experiment& experiment, const std::vector<ParameterChange>& overrides) {
  for (const Axis& axis : experiment.axes) {
    for (const ParameterChange& varied : parameters_of(axis)) {
      for (const ParameterChange& one : overrides) {
        if (one.name != varied.name) continue;
        throw std::runtime_error(as_line(fmt::format(
            "{}: expected a parameter that no axis sets, found '{}', which axis '{}' sets at {}; choose its value with "
            "--only {}=CHOICE",
            one.source.empty() ? "--set" : one.source, one.name, axis.name, varied.source, axis.name)));
      }
    }
  }
}

/// Each plan of an experiment has a folder of its own.
std::filesystem::path usual_folder(const SessionOptions& options, const std::string& name) {
  std::string changes;
  const auto add = [&changes](const char* option, const std::string& value) {
    changes.append(option).append("=").append(value).append(1, '\0');
  };
  if (options.trials) add("trials", std::to_string(*options.trials));
  if (options.width) add("width", std::to_string(*options.width));
  if (options.seed != SessionOptions().seed) add("seed", std::to_string(options.seed));
  for (const auto& [option, values] :
       {std::pair("room", &options.rooms), std::pair("mode", &options.modes), std::pair("motion", &options.motions),
        std::pair("light", &options.lights), std::pair("only", &options.only),
        std::pair("set", &options.parameters.assignments)}) {
    for (const std::string& value : *values) add(option, value);
  }
  for (const std::filesystem::path& file : options.parameters.files) add("params", file.string());
  if (!options.scripts.empty()) add("scripts", options.scripts.string());
  const std::filesystem::path all = std::filesystem::path("out") / "experiments";
  return all / (changes.empty() ? name : fmt::format("{}-{:08x}", name, content_hash(changes) & 0xffffffffU));
}

}  // namespace

Session::Session(const SessionOptions& options)
    : scripts_(scripts_root(options.scripts)),
      experiment_(with_usual_choices(wanted_experiment(options))),
      cells_(cells_of(experiment_)),
      tasks_(tasks_of(experiment_, options.seed)),
      folder_(options.out.empty() ? usual_folder(options, experiment_.name) : options.out),
      results_(folder_ / "tasks") {
  require_no_axis_sets(experiment_, experiment_.overrides.parameters);
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

/// Checks all conditions at the start, because an error hours later would cost time. Stores the origin of each.
void Session::prepare_conditions() {
  FileHashes files;
  LoadedFiles used;  // by all trials
  origins_.resize(cells_.size());
  const auto digest = [](std::uint64_t hash) { return fmt::format("{:016x}", hash); };
  for (const Task& task : tasks_) {
    std::vector<Origin>& origins = origins_[task.cell];
    if (turn_of(task) < origins.size()) continue;  // the same as an earlier one
    Condition condition = condition_of(task);
    LoadedFiles loaded = check_trial(condition, task.seed, scripts_);
    used.parameters.merge(loaded.parameters);
    used.states.merge(loaded.states);
    used.actions.merge(loaded.actions);
    Origin& origin = origins.emplace_back();
    origin["program"] = REORIENT_VERSION;
    for (const auto& [script, hash] : loaded.scripts) origin["script " + script] = digest(hash);
    loaded_scripts_.merge(loaded.scripts);
    ParameterOptions parameters;
    parameters.files.assign(condition.parameter_files.begin(), condition.parameter_files.end());
    parameters.changes = std::exchange(condition.parameters, {});
    condition.parameter_files.clear();
    for (const ParameterChange& change : overrides_of(parameters)) origin[change.name] = change.value;
    std::istringstream lines(as_text(condition));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t end = line.find(" = ");
      std::string& value = origin[line.substr(0, end)];  // some have several values, in their order
      value.append(value.empty() ? "" : ", ").append(line, std::min(line.size(), end + 3));
    }
    origin["file of the body"] = digest(files.of(body_file(condition.body)));
    origin["file of the field"] = digest(files.of(loaded.venue.field));
    if (!loaded.venue.room.empty()) origin["file of the room"] = digest(files.of(loaded.venue.room));
  }
  require_used_parameters(used.parameters);
  require_known_names(experiment_.measures, used);
}

/// A parameter that no trial has would compare equal trials. Condition files are for several experiments, and may set
/// parameters of behaviors that this one does not load.
void Session::require_used_parameters(const std::set<std::string>& used) const {
  std::vector<ParameterChange> changes;
  for (const Axis& axis : experiment_.axes) {
    for (const AxisChoice& choice : axis.choices)
      changes.insert(changes.end(), choice.patch.parameters.begin(), choice.patch.parameters.end());
  }
  rename_parameters(changes);
  for (const ParameterChange& change : without_peers(std::move(changes))) {
    if (!used.contains(change.name))
      throw std::runtime_error(as_line(fmt::format(
          "{}: expected a parameter of a script that a cell of the experiment loads, found '{}'{}", change.source,
          change.name, did_you_mean(change.name, std::vector<std::string>(used.begin(), used.end())))));
  }
}

Origin Session::origin_of(const Task& task) const {
  Origin origin = origins_[task.cell][turn_of(task)];
  origin["seed"] = std::to_string(task.seed);
  return origin;
}

/// Each trial reads the scripts: an edit since the session began would mix results of different scripts.
void Session::require_unchanged_scripts() const {
  const ScriptTexts texts = read_scripts(scripts_);
  for (const auto& [script, hash] : loaded_scripts_) {
    const ScriptText* const text = texts.find(script);
    if (text == nullptr || content_hash(text->text) != hash)
      throw std::runtime_error((scripts_ / script).string() +
                               ": expected an unchanged script during the experiment, found changes");
  }
}

void Session::run(int number) {
  if (result(number)) return;
  const Task& task = this->task(number);
  const TrialResult result = run_trial(condition_of(task), task.seed, scripts_, rooms_);
  require_unchanged_scripts();
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
