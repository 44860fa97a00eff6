// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/compass_table.h"

#include <cmath>
#include <optional>
#include <ostream>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/text_table.h"
#include "workbench/experiments/tables/compass_rows.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

/// "frame", "1s", "3s".
std::string time_key(std::size_t time) {
  return kLookTimes[time] == 0.0 ? "frame" : fmt::format("{:.0f}s", kLookTimes[time]);
}

void add(ordered_json& json, const std::string& key, double value, const Interval& interval) {
  json[key] = value;
  json[key + "_low"] = interval.low;
  json[key + "_high"] = interval.high;
}

ordered_json as_json(const std::optional<double>& value) { return value ? ordered_json(*value) : ordered_json(); }

/// Flipped mirrored poses and flipped right poses, by the method's own rule.
std::string flips_of(const CompassFigure& figure) {
  if (!figure.flipped || !figure.false_flipped) return "-";
  return fmt::format("{:.1f} %, {:.1f} %", 100.0 * *figure.flipped, 100.0 * *figure.false_flipped);
}

}  // namespace

void print_compasses(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out) {
  TextTable lines(1);
  for (const Axis& axis : experiment.axes) lines[0].push_back(as_line(axis.name));
  for (const char* title : {"method", "trials", "looks"}) lines[0].emplace_back(title);
  for (std::size_t time = 0; time < kLookTimes.size(); ++time) {
    lines[0].push_back("AUC " + time_key(time) + " [95 %]");
    lines[0].push_back("equal errors [95 %]");
  }
  lines[0].push_back("flipped, false");
  for (const CompassRow& row : compass_rows(experiment, cells)) {
    std::vector<std::string> line;
    for (const std::string& choice : row.choices) line.push_back(as_line(choice));
    line.emplace_back(kCompassMethods[row.method]);
    line.push_back(std::to_string(row.trials));
    line.push_back(std::to_string(row.looks));
    for (const CompassFigure& figure : row.figures) {
      line.push_back(
          fmt::format("{:.3f} [{:.3f}, {:.3f}]", figure.area, figure.area_interval.low, figure.area_interval.high));
      line.push_back(fmt::format("{:.1f} % [{:.1f}, {:.1f}]", 100.0 * figure.equal_error,
                                 100.0 * figure.equal_error_interval.low, 100.0 * figure.equal_error_interval.high));
    }
    line.push_back(flips_of(row.figures.back()));
    lines.push_back(std::move(line));
  }
  print_table(lines, experiment.axes.size() + 1, out);
}

std::string compasses_as_json(const Experiment& experiment, const std::vector<CellResults>& cells) {
  std::string text;
  for (const CompassRow& row : compass_rows(experiment, cells)) {
    ordered_json json;
    for (std::size_t i = 0; i < experiment.axes.size(); ++i)
      json[as_utf8(experiment.axes[i].name)] = as_utf8(row.choices[i]);
    json["method"] = kCompassMethods[row.method];
    json["trials"] = row.trials;
    json["looks"] = row.looks;
    for (std::size_t time = 0; time < kLookTimes.size(); ++time) {
      const CompassFigure& figure = row.figures[time];
      add(json, "auc_" + time_key(time), figure.area, figure.area_interval);
      add(json, "eer_" + time_key(time), figure.equal_error, figure.equal_error_interval);
      json["silent_" + time_key(time)] = figure.silent;
      json["flipped_" + time_key(time)] = as_json(figure.flipped);
      json["false_flipped_" + time_key(time)] = as_json(figure.false_flipped);
    }
    text.append(text.empty() ? "[\n  " : ",\n  ").append(json.dump());
  }
  return (text.empty() ? "[" : text + "\n") + "]\n";
}

}  // namespace reorient
