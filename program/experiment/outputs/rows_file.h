// SPDX-License-Identifier: MIT
// What --json of an experiment wrote, read back.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "workbench/experiments/statistics/interval.h"
#include "workbench/experiments/tables/outcome.h"

namespace reorient {

/// As much of a row as a comparison needs.
struct StoredRow {
  std::vector<std::pair<std::string, std::string>> choices;  ///< of each axis, in the file's order
  std::vector<Outcome> outcomes;                             ///< no two of one seed
  int false_flips = 0;
  double right_hours = 0.0;
  Interval false_flip_rate;  ///< per right hour
};

/// One row or more, no two with the same choices. Throws std::runtime_error with one line: the file, what is wrong
/// with it, how to come by a good one.
std::vector<StoredRow> read_rows(const std::filesystem::path& file);

}  // namespace reorient
