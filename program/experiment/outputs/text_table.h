// SPDX-License-Identifier: MIT
// Tables for a terminal.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace reorient {

using TextTable = std::vector<std::vector<std::string>>;  ///< rows with the same number of cells

/// Each column as wide as its longest text; the first `left` columns are left-aligned, the others right-aligned.
void print_table(const TextTable& table, std::size_t left, std::ostream& out);

/// With one decimal; "-" without a value.
std::string one_decimal(const std::optional<double>& value);

}  // namespace reorient
