// SPDX-License-Identifier: MIT
// The differences between two tables of experiments, in pairs with the same seed.
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "program/experiment/outputs/rows_file.h"

namespace reorient {

struct RowPair {
  std::string name;  ///< choices that both have: "room hall, mode paper"; empty: none
  StoredRow first;
  StoredRow second;
};

struct PairedRows {
  std::string first_name;  ///< "before.json", "mode default"
  std::string second_name;
  std::vector<RowPair> pairs;
  std::vector<std::string> only_first;  ///< names of rows without a partner
  std::vector<std::string> only_second;
};

/// Rows of equal choices, in any order of the axes.
PairedRows pair_rows(std::pair<std::string, std::vector<StoredRow>> first,
                     std::pair<std::string, std::vector<StoredRow>> second);

/// Rows that differ in one axis alone. Throws std::runtime_error with one line if the axis or choice is unknown.
PairedRows pair_choices(const std::vector<StoredRow>& rows, const std::string& axis, const std::string& from,
                        const std::string& to);

/// Throws std::runtime_error with one line if there is no pair.
void print_comparison(const PairedRows& rows, std::ostream& out);

}  // namespace reorient
