// SPDX-License-Identifier: MIT
// Reads a table that --json of an experiment wrote.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "workbench/experiments/statistics/interval.h"
#include "workbench/experiments/tables/outcome.h"

namespace reorient {

/// The part of a row that a comparison needs.
struct StoredRow {
  std::vector<std::pair<std::string, std::string>> choices;  ///< of each axis, in the file's order
  std::vector<Outcome> outcomes;                             ///< with different seeds
  int false_flips = 0;
  double right_hours = 0.0;
  Interval false_flip_rate;  ///< per right hour
};

/// One row or more, no two with the same choices. Throws std::runtime_error with one line: the file, the mistake
/// in it, and how to write a valid one.
std::vector<StoredRow> read_rows(const std::filesystem::path& file);

}  // namespace reorient
