// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/measure_table.h"

#include <ostream>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/text_table.h"

namespace reorient {
namespace {

void add_lines(const Experiment& experiment, const CellResults& cell, TextTable& lines) {
  for (std::size_t i = 0; i < experiment.measures.size(); ++i) {
    const MeasureRow row = i < cell.row.measures.size() ? cell.row.measures[i] : MeasureRow();
    const bool is_known = row.trials > 0;
    std::vector<std::string>& line = lines.emplace_back();
    for (const std::string& choice : cell.choices) line.push_back(as_line(choice));
    line.push_back(as_line(experiment.measures[i].label()));
    line.push_back(unit_of(experiment.measures[i]));
    line.push_back(std::to_string(row.trials));
    line.push_back(is_known ? fmt::format("{:.3f}", row.mean) : "-");
    line.push_back(row.interval ? fmt::format("[{:.3f}, {:.3f}]", row.interval->low, row.interval->high) : "-");
    line.push_back(is_known ? fmt::format("{:.3f}", row.least) : "-");
    line.push_back(is_known ? fmt::format("{:.3f}", row.most) : "-");
  }
}

}  // namespace

void print_measures(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out) {
  if (experiment.measures.empty()) return;
  TextTable lines(1);
  for (const Axis& axis : experiment.axes) lines[0].push_back(as_line(axis.name));
  for (const char* const title : {"measure", "unit", "trials", "mean of a trial", "[95 %]", "least", "most"})
    lines[0].emplace_back(title);
  for (const CellResults& cell : cells) add_lines(experiment, cell, lines);
  for (const CellResults& row : pooled_over_rooms(experiment, cells)) add_lines(experiment, row, lines);
  out << '\n';
  print_table(lines, experiment.axes.size() + 2, out);
}

void add_measures(const std::vector<Measure>& measures, const std::vector<MeasureRow>& rows,
                  nlohmann::ordered_json& json) {
  using nlohmann::ordered_json;
  if (measures.empty()) return;
  ordered_json& all = json["measures"] = ordered_json::object();
  for (std::size_t i = 0; i < measures.size() && i < rows.size(); ++i) {
    const MeasureRow& row = rows[i];
    const auto known = [&](double value) { return row.trials > 0 ? ordered_json(value) : ordered_json(); };
    all[as_utf8(measures[i].label())] = {{"unit", unit_of(measures[i])},
                                         {"trials", row.trials},
                                         {"mean", known(row.mean)},
                                         {"low", row.interval ? ordered_json(row.interval->low) : ordered_json()},
                                         {"high", row.interval ? ordered_json(row.interval->high) : ordered_json()},
                                         {"least", known(row.least)},
                                         {"most", known(row.most)}};
  }
}

}  // namespace reorient
