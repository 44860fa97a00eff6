// SPDX-License-Identifier: MIT
#include "workbench/files/csv_text.h"

#include <charconv>

namespace reorient {
namespace {

bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error != std::errc::invalid_argument && end == text.data() + text.size();
}

/// Spreadsheets skip blanks, tabs and line ends before a formula.
bool is_formula(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return false;
  return std::string_view("=+-@").find(text[begin]) != std::string_view::npos && !is_number(text.substr(begin));
}

}  // namespace

std::string csv_cell(std::string_view text) {
  const bool is_executed = is_formula(text);
  if (!is_executed && text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = is_executed ? "\"'" : "\"";
  for (const char letter : text) cell += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return cell + '"';
}

}  // namespace reorient
