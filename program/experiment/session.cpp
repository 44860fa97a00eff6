#include "program/experiment/session.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "engine/script/script_texts.h"
#include "program/experiment/trial_runner.h"
#include "program/run/venue.h"
#include "program/script_names.h"
#include "workbench/experiments/condition/experiment_file.h"
#include "workbench/files/home.h"
#include "workbench/files/script_files.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

constexpr std::string_view kHall = "hall";  // the built-in one, where rooms are named
constexpr std::string_view kTomlFiles[] = {".toml"};

ConditionPatch named_condition(const std::string& named) {
  const std::filesystem::path file = asset_file("conditions", named, kTomlFiles);
  std::error_code error;
  if (std::filesystem::exists(file, error)) return read_condition(file);
  throw std::runtime_error("there is no condition '" + as_line(named) + "'" +
                           did_you_mean(named, asset_names("conditions", kTomlFiles)) +
                           "; name a file, or one of assets/conditions");
}

Experiment named_experiment(const std::string& named) {
  const std::filesystem::path file = asset_file("experiments", named, kTomlFiles);
  std::error_code error;
  if (std::filesystem::exists(file, error)) return read_experiment(file, named_condition);
  throw std::runtime_error("there is no experiment '" + named + "'" +
                           did_you_mean(named, asset_names("experiments", kTomlFiles)) +
                           "; name a file, or one of assets/experiments");
}

/// What an axis does not have may be a condition file, shipped or a person's own.
AxisChoice choice_from_file(const Axis& axis, const std::string& named) {
  const std::filesystem::path file = asset_file("conditions", named, kTomlFiles);
  std::error_code error;
  if (std::filesystem::exists(file, error)) return {file.stem().string(), read_condition(file)};
  std::vector<std::string> known = asset_names("conditions", kTomlFiles);
  for (const AxisChoice& choice : axis.choices) known.push_back(choice.name);
  throw std::runtime_error("the axis " + as_line(axis.name) + " has no choice '" + as_line(named) + "'" +
                           did_you_mean(named, known) + "; it may be a condition file, too");
}

void choose_as_told(const SessionOptions& options, Experiment& experiment) {
  std::map<std::string, std::vector<std::string>> chosen;
  if (!options.modes.empty()) chosen["mode"] = options.modes;
  if (!options.motions.empty()) chosen["motion"] = options.motions;
  if (!options.lights.empty()) chosen["light"] = options.lights;
  for (const std::string& one : options.only) {
    const std::size_t equals = one.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == one.size())
      throw std::runtime_error("--only " + as_line(one) + ": write AXIS=CHOICE");
    chosen[one.substr(0, equals)].push_back(one.substr(equals + 1));
  }
  for (const auto& [axis, names] : chosen) choose(experiment, axis, names, choice_from_file);
}

/// With what the command line says otherwise.
Experiment wanted_experiment(const SessionOptions& options) {
  Experiment experiment = named_experiment(options.experiment);
  if (options.trials) experiment.trials = *options.trials;
  choose_as_told(options, experiment);
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
      throw std::runtime_error("the room " + as_line(room) + " is named twice");
    axis.choices.push_back({name, {}});
    axis.choices.back().patch.room = room == kHall ? "" : room;
  }
  std::erase_if(experiment.axes, [](const Axis& one) { return one.name == "room"; });
  experiment.axes.insert(experiment.axes.begin(), std::move(axis));
  return experiment;
}

std::uint64_t hash_of(const ScriptTexts& texts) {
  std::string all;
  for (const std::string& file : texts.files())
    all.append(file).append(1, '\0').append(texts.find(file)->text).append(1, '\0');
  return content_hash(all);
}

}  // namespace

Session::Session(const SessionOptions& options)
    : scripts_(scripts_root(options.scripts)),
      experiment_(wanted_experiment(options)),
      cells_(cells_of(experiment_)),
      tasks_(tasks_of(experiment_, options.seed)),
      folder_(options.out.empty() ? std::filesystem::path("out") / "experiments" / experiment_.name : options.out),
      results_(folder_ / "tasks") {
  const std::vector<ParameterChange> overrides = overrides_of(options.parameters);
  for (Cell& cell : cells_) {
    if (options.width) cell.condition.width = *options.width;
    cell.condition.parameters.insert(cell.condition.parameters.end(), overrides.begin(), overrides.end());
  }
  scripts_hash_ = hash_of(read_scripts(scripts_));
  check_conditions();
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

/// What is wrong with one of them is better told now than hours later.
void Session::check_conditions() const {
  const ScriptTexts texts = read_scripts(scripts_);
  const int different = std::max(1, static_cast<int>(experiment_.alternates.size()));
  for (const Task& task : tasks_) {
    if (task.trial >= different) continue;  // the same as an earlier one, but for the seed
    const SimulationOptions options = options_of(condition_of(task), task.seed, scripts_);
    const RecordedBehaviors nobody;
    const ScenarioHost scenario(texts, scenario_file(scripts_, texts, options.scenario),
                                overrides_of(options.parameters), nobody);
    static_cast<void>(venue_of(options, scenario.setting()));
  }
}

std::uint64_t Session::origin_of(const Task& task) const {
  const Condition condition = condition_of(task);
  std::string text = fmt::format("{}\n{}\n{:x}\n{}", REORIENT_VERSION, task.seed, scripts_hash_, as_text(condition));
  for (const ParameterChange& change : overrides_of(options_of(condition, task.seed, scripts_).parameters))
    text.append(change.name).append(" = ").append(change.value).append("\n");
  return content_hash(text);
}

void Session::run(int number) {
  const Task& task = this->task(number);
  results_.write(number, origin_of(task), run_trial(condition_of(task), task.seed, scripts_, rooms_));
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
  for (const Task& task : tasks_) results[task.cell].trials.push_back(result(task.number).value());
  for (CellResults& cell : results) cell.row = row_of(cell.trials);
  return results;
}

}  // namespace reorient
