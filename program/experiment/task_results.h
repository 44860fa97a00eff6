// SPDX-License-Identifier: MIT
// The results of an experiment's tasks on disk, one file per task. A task with a result never runs again.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// Everything that determines a result, by name: the seed, each condition, each parameter, and digests of the files.
using Origin = std::map<std::string, std::string>;

class TaskResults {
 public:
  explicit TaskResults(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path file_of(int task) const;

  /// Writes a temporary file and renames it; creates the folder. Throws std::runtime_error with one line.
  void write(int task, const Origin& origin, const TrialResult& result) const;

  /// Nothing if the task has no result yet. Throws std::runtime_error with one line if the file cannot be read, or has
  /// another origin; the line names what differs.
  std::optional<TrialResult> read(int task, const Origin& origin) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace reorient
