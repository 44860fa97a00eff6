// SPDX-License-Identifier: MIT
// A running experiment: its cells, its tasks, and the folder of their results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "program/experiment/task_results.h"
#include "program/options.h"
#include "program/robots.h"
#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/plan/plan.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

struct SessionOptions {
  std::string experiment;  ///< a file, or the name of a shipped one
  std::filesystem::path scripts;
  std::optional<int> trials;       ///< of each cell; nothing: the file's
  std::optional<int> width;        ///< of the images; nothing: the file's
  std::uint64_t seed = 1;          ///< of the first trial of each cell
  std::vector<std::string> rooms;  ///< instead of the file's own axis "room"; empty: the file's
  std::vector<std::string> modes;  ///< of the axis "mode": its choices, or condition files; empty: the usual ones
  std::vector<std::string> motions;
  std::vector<std::string> lights;
  std::vector<std::string> only;  ///< "AXIS=CHOICE", of any axis
  ParameterOptions parameters;    ///< for every cell, applied after its own
  std::filesystem::path out;      ///< empty: out/experiments/NAME, with a digest of the options that change the plan
};

class Session {
 public:
  /// Throws std::runtime_error with one line if any of the conditions has a mistake.
  explicit Session(const SessionOptions& options);

  const Experiment& experiment() const { return experiment_; }
  const std::vector<Task>& tasks() const { return tasks_; }
  const std::filesystem::path& folder() const { return folder_; }
  // Tasks have numbers.

  /// The condition of a task.
  Condition condition_of(int number) const { return condition_of(task(number)); }
  std::uint64_t seed_of(int number) const { return task(number).seed; }
  const std::filesystem::path& scripts() const { return scripts_; }

  /// "room hall, mode paper, trial 3 (seed 3)".
  std::string name_of(int number) const;

  /// Runs a task, unless another process has done so meanwhile, and writes its result. Throws std::runtime_error with
  /// one line.
  void run(int number);
  /// Nothing if the task did not run yet. Throws std::runtime_error with one line if the result has another origin.
  std::optional<TrialResult> result(int number) const;
  /// The tasks without a result. Throws as result().
  std::vector<int> missing(const std::vector<int>& tasks) const;

  /// In the order of the plan, once no result is missing. Throws std::runtime_error with one line if one is missing.
  std::vector<CellResults> cell_results() const;

 private:
  const Task& task(int number) const { return tasks_[static_cast<std::size_t>(number) - 1]; }
  Condition condition_of(const Task& task) const;
  std::size_t turn_of(const Task& task) const;
  void prepare_conditions();
  Origin origin_of(const Task& task) const;
  void require_unchanged_scripts() const;
  void require_used_parameters(const std::set<std::string>& used) const;

  std::filesystem::path scripts_;
  Experiment experiment_;
  std::vector<Cell> cells_;
  std::vector<Task> tasks_;
  std::filesystem::path folder_;
  TaskResults results_;
  std::map<std::string, std::uint64_t> loaded_scripts_;  ///< digests, by name
  std::vector<std::vector<Origin>> origins_;  ///< of each cell's conditions, one for each alternate; without the seed
  RoomCache rooms_;
};

}  // namespace reorient
