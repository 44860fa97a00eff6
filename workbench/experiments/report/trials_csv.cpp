// SPDX-License-Identifier: MIT
#include "workbench/experiments/report/trials_csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

#include "engine/parameters/utf8.h"
#include "workbench/experiments/report/trial_columns.h"
#include "workbench/files/csv_text.h"

namespace reorient {
namespace {

std::string text_of(const std::string& value) { return value; }
std::string text_of(bool yes) { return yes ? "true" : "false"; }
/// The shortest text that reads as the same number.
template <typename Number>
std::string text_of(Number value) {
  if constexpr (std::is_floating_point_v<Number>) {
    if (std::isnan(value)) return "nan";  // not "-nan": the sign of 0/0 depends on the processor
  }
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}
template <typename Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? text_of(*value) : "";
}

void add_line(std::string& text, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) text.append(i == 0 ? "" : ",").append(csv_cell(as_line(fields[i])));
  text += "\r\n";
}

}  // namespace

std::string trials_as_csv(const Report& report) {
  std::vector<std::string> line;
  for (const Axis& axis : report.experiment.axes) line.push_back(axis.name);
  line.emplace_back("task");
  visit_columns([&line](const char* name, const auto&) { line.emplace_back(name); }, TrialResult());
  for (const Measure& measure : report.experiment.measures) line.push_back(measure.label());
  std::string text;
  add_line(text, line);
  int task = 0;
  for (const CellResults& cell : report.cells) {
    for (const TrialResult& trial : cell.trials) {
      line = cell.choices;
      line.push_back(std::to_string(++task));
      visit_columns([&line](const char*, const auto& value) { line.push_back(text_of(value)); }, trial);
      for (std::size_t i = 0; i < report.experiment.measures.size(); ++i)
        line.push_back(i < trial.measures.size() ? text_of(trial.measures[i]) : "");
      add_line(text, line);
    }
  }
  return text;
}

}  // namespace reorient
