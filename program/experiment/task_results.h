// SPDX-License-Identifier: MIT
// The results of an experiment's tasks on disk, one file per task. A task with a result never runs again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

class TaskResults {
 public:
  explicit TaskResults(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path file_of(int task) const;

  /// `origin`: digest of everything that determines the result. Writes a temporary file and renames it; creates the
  /// folder. Throws std::runtime_error with one line.
  void write(int task, std::uint64_t origin, const TrialResult& result) const;

  /// Nothing if the task has no result yet. Throws std::runtime_error with one line if the file cannot be read, or has
  /// another origin.
  std::optional<TrialResult> read(int task, std::uint64_t origin) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace reorient
