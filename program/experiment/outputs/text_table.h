// SPDX-License-Identifier: MIT
// Tables for a terminal.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace reorient {

using TextTable = std::vector<std::vector<std::string>>;  ///< line by line, all with as many cells as the first

/// Each column as wide as its texts; the first `left` columns begin at their left edge, the others end at their right.
void print_table(const TextTable& table, std::size_t left, std::ostream& out);

/// With one decimal; "-" without a value.
std::string one_decimal(const std::optional<double>& value);

}  // namespace reorient
