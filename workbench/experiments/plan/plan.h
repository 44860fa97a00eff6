// SPDX-License-Identifier: MIT
// An experiment as a numbered list of trials, so that any part of it can be run on any machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "workbench/experiments/condition/condition.h"

namespace reorient {

struct Task {
  int number = 1;          ///< starts at 1
  std::size_t cell = 0;    ///< of cells_of()
  int trial = 0;           ///< index within its cell, starting at 0
  std::uint64_t seed = 1;  ///< the same for the same trial of each cell: cells are compared in pairs
};

/// Cell after cell, so that trials in one room follow each other. Throws std::runtime_error if there are too many.
std::vector<Task> tasks_of(const Experiment& experiment, std::uint64_t first_seed);

/// The condition of a task: that of its cell, with one of the alternates in turn.
Condition condition_of(const Experiment& experiment, const Cell& cell, const Task& task);

/// "17", "1-64" or "1-64,70": the numbers in their order, each once. Throws std::runtime_error with one line for
/// other text, or if a number is not in 1 to `count`.
std::vector<int> numbers_in(std::string_view list, int count);

}  // namespace reorient
