// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/text_table.h"

#include <algorithm>
#include <ostream>

#include <spdlog/fmt/fmt.h>

namespace reorient {

void print_table(const TextTable& table, std::size_t left, std::ostream& out) {
  std::vector<std::size_t> widths(table.empty() ? 0 : table.front().size());
  for (const std::vector<std::string>& line : table) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  for (const std::vector<std::string>& line : table) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i)
      text += i < left ? fmt::format("{:<{}}  ", line[i], widths[i]) : fmt::format("{:>{}}  ", line[i], widths[i]);
    out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
  }
}

std::string one_decimal(const std::optional<double>& value) { return value ? fmt::format("{:.1f}", *value) : "-"; }

}  // namespace reorient
