// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/rows_report.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/compass_table.h"
#include "program/experiment/outputs/measure_table.h"
#include "program/experiment/outputs/pose_table.h"
#include "program/experiment/outputs/text_table.h"
#include "workbench/experiments/tables/compass_rows.h"
#include "workbench/experiments/tables/outcome.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

double share(int part, int whole) { return whole == 0 ? 0.0 : static_cast<double>(part) / whole; }

std::string percent(double value) { return fmt::format("{:.1f}", 100.0 * value); }

std::string mean_text(const TimeRow& row) {
  if (!row.mean) return "-";
  if (!row.interval) return fmt::format("{:.1f}", *row.mean);
  return fmt::format("{:.1f} [{:.1f}, {:.1f}]", *row.mean, row.interval->low, row.interval->high);
}

std::vector<std::string> cells_of(const CellResults& cell) {
  const Row& row = cell.row;
  std::vector<std::string> cells;
  for (const std::string& choice : cell.choices) cells.push_back(as_line(choice));
  const std::string failed =
      row.disturbed == 0
          ? "-"
          : fmt::format("{} of {}, {} % [{}, {}]", row.failed, row.disturbed, percent(share(row.failed, row.disturbed)),
                        percent(row.failed_rate.low), percent(row.failed_rate.high));
  for (std::string text :
       {std::to_string(row.trials), failed, mean_text(row.right), one_decimal(row.right_median),
        one_decimal(row.right_p90), mean_text(row.by_command), std::to_string(row.flips), std::to_string(row.purges),
        std::to_string(row.false_flips), fmt::format("{:.2f}", row.right_hours)})
    cells.push_back(std::move(text));
  return cells;
}

/// Published measurements of cases that this experiment contains, too.
TextTable lines_of_references(const Experiment& experiment, const std::vector<CellResults>& cells) {
  TextTable lines;
  const auto rate = [](const std::optional<double>& value) { return value ? percent(*value) + " %" : "-"; };
  for (const Reference& reference : experiment.references) {
    const bool is_tried = std::any_of(cells.begin(), cells.end(), [&](const CellResults& cell) {
      return belongs_to(reference, experiment, cell.choices);
    });
    if (!is_tried) continue;
    if (lines.empty())
      lines.push_back({"measured by", "case", "trials", "failed", "corrected after, s", "flip", "purge"});
    std::string choices;
    for (const auto& [axis, choice] : reference.choices) choices += (choices.empty() ? "" : ", ") + as_line(choice);
    lines.push_back({as_line(reference.label), choices, reference.trials ? std::to_string(*reference.trials) : "-",
                     rate(reference.failed), one_decimal(reference.mean_s), rate(reference.flip),
                     rate(reference.purge)});
  }
  return lines;
}

void print_trials(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out) {
  TextTable lines(1);
  for (const Axis& axis : experiment.axes) lines[0].push_back(as_line(axis.name));
  for (const char* title : {"trials", "failed [95 %]", "right after, s", "median", "p90", "corrected after, s", "flips",
                            "purges", "false flips", "right hours"})
    lines[0].emplace_back(title);
  for (const CellResults& cell : cells) lines.push_back(cells_of(cell));
  for (const CellResults& row : pooled_over_rooms(experiment, cells)) lines.push_back(cells_of(row));
  print_table(lines, experiment.axes.size(), out);
  const TextTable references = lines_of_references(experiment, cells);
  if (references.empty()) return;
  out << '\n';
  print_table(references, 2, out);
}

ordered_json outcome_as_json(const Outcome& outcome) {
  return {{"seed", outcome.seed},
          {"disturbed", outcome.disturbed},
          {"failed", outcome.failed},
          {"right_after_s", or_null(outcome.right_after)},
          {"corrected_after_s", or_null(outcome.corrected_after)},
          {"corrected_by", outcome.corrected_by ? ordered_json(to_string(*outcome.corrected_by)) : ordered_json()},
          {"false_flips", outcome.false_flips}};
}

/// A line for each value of a row, and for each entry of a list in it.
std::string on_lines(const ordered_json& row) {
  std::string text = "  {";
  for (const auto& [key, value] : row.items()) {
    text.append(text.size() > 3 ? ",\n    " : "\n    ").append(ordered_json(key).dump()).append(": ");
    if (!value.is_array()) {
      text += value.dump();
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      text.append(i == 0 ? "[\n      " : ",\n      ").append(value[i].dump());
    text += value.empty() ? "[]" : "\n    ]";
  }
  return text + "\n  }";
}

}  // namespace

void print_rows(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out) {
  if (have_looks(cells)) {
    print_compasses(experiment, cells, out);
  } else if (have_pose_errors(cells)) {
    print_pose_errors(experiment, cells, out);
  } else {
    print_trials(experiment, cells, out);
  }
  print_measures(experiment, cells, out);
  for (const CellResults& cell : cells) {
    if (const std::string note = not_started_note(cell); !note.empty()) out << '\n' << as_line(note) << '\n';
  }
}

void check_axis_names(const Experiment& experiment) {
  CellResults cell;
  const std::vector<Cell> cells = reorient::cells_of(experiment);
  if (std::any_of(cells.begin(), cells.end(), [](const Cell& one) { return one.condition.compasses; }))
    cell.trials.emplace_back().looks.emplace_back();
  Experiment without_axes;
  without_axes.measures = experiment.measures;
  const auto numbers = ordered_json::parse(rows_as_json(without_axes, {cell})).at(0);
  for (const Axis& axis : experiment.axes) {
    if (numbers.contains(as_utf8(axis.name)))
      throw std::runtime_error("axis: expected a name that is not a column of the results, found '" +
                               as_line(axis.name) + "'");
  }
}

std::string rows_as_json(const Experiment& experiment, const std::vector<CellResults>& cells) {
  if (have_looks(cells)) return compasses_as_json(experiment, cells);
  const std::vector<CellResults> pooled = pooled_over_rooms(experiment, cells);
  std::vector<std::reference_wrapper<const CellResults>> rows(cells.begin(), cells.end());
  rows.insert(rows.end(), pooled.begin(), pooled.end());
  std::string text;
  for (const CellResults& cell : rows) {
    const Row& row = cell.row;
    ordered_json json;
    for (std::size_t i = 0; i < experiment.axes.size(); ++i)
      json[as_utf8(experiment.axes[i].name)] = as_utf8(cell.choices[i]);
    json["trials"] = row.trials;
    json["disturbed"] = row.disturbed;
    json["not_started"] = row.not_started;
    json["failed"] = share(row.failed, row.disturbed);
    json["failed_low"] = row.failed_rate.low;
    json["failed_high"] = row.failed_rate.high;
    json["uninformative"] = share(row.uninformative, row.disturbed);
    json["flip"] = share(row.flip, row.disturbed);
    json["purge"] = share(row.purge, row.disturbed);
    json["reset"] = share(row.reset, row.disturbed);
    const bool of_command = experiment.times == TimeOf::command;
    json["mean_s"] = or_null(of_command ? row.by_command.mean : row.right.mean);
    json["median_s"] = or_null(of_command ? row.command_median : row.right_median);
    json["p90_s"] = or_null(of_command ? row.command_p90 : row.right_p90);
    json["flip_mean_s"] = or_null(row.flip_time.mean);
    json["purge_mean_s"] = or_null(row.purge_time.mean);
    json["right_mean_s"] = or_null(row.right.mean);
    json["right_mean_low"] = or_null(row.right.interval ? std::optional(row.right.interval->low) : std::nullopt);
    json["right_mean_high"] = or_null(row.right.interval ? std::optional(row.right.interval->high) : std::nullopt);
    json["right_median_s"] = or_null(row.right_median);
    json["right_p90_s"] = or_null(row.right_p90);
    json["flips"] = row.flips;
    json["purges"] = row.purges;
    json["false_flips"] = row.false_flips;
    json["false_purges"] = row.false_purges;
    json["right_hours"] = row.right_hours;
    json["false_flips_per_hour_low"] = or_null(row.false_flip_rate.low);
    json["false_flips_per_hour_high"] = or_null(row.false_flip_rate.high);
    json["displaced_trials"] = row.displaced;
    json["displaced_failed"] = share(row.displaced_failed, row.displaced);
    json["displaced_mean_s"] = or_null(row.displaced_right.mean);
    json["usable_mean_s"] = or_null(row.usable.mean);
    json["confidence_area"] = or_null(row.confidence_area);
    json["uninformative_time"] = or_null(row.uninformative_time);
    json["calibration_samples"] = row.calibration_samples;
    json["calibration_error"] = or_null(row.calibration_error);
    add_pose_errors(row.pose, json);
    add_measures(experiment.measures, row.measures, json);
    json["outcomes"] = ordered_json::array();
    for (const TrialResult& trial : cell.trials) json["outcomes"].push_back(outcome_as_json(outcome_of(trial)));
    text.append(text.empty() ? "[\n" : ",\n").append(on_lines(json));
  }
  return (text.empty() ? "[" : text + "\n") + "]\n";
}

}  // namespace reorient
