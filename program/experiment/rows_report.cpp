#include "program/experiment/rows_report.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ordered_json(*value) : ordered_json();
}

double share(int part, int whole) { return whole == 0 ? 0.0 : static_cast<double>(part) / whole; }

std::string percent(double value) { return fmt::format("{:.1f}", 100.0 * value); }
std::string seconds(const std::optional<double>& value) { return value ? fmt::format("{:.1f}", *value) : "-"; }

std::string mean_text(const TimeRow& row) {
  if (!row.mean) return "-";
  return fmt::format("{:.1f} [{:.1f}, {:.1f}]", *row.mean, row.interval->low, row.interval->high);
}

std::vector<std::string> cells_of(const CellRow& cell) {
  const Row& row = cell.row;
  std::vector<std::string> cells;
  for (const std::string& choice : cell.choices) cells.push_back(as_line(choice));
  const std::string failed =
      row.disturbed == 0
          ? "-"
          : fmt::format("{} of {}, {} % [{}, {}]", row.failed, row.disturbed, percent(share(row.failed, row.disturbed)),
                        percent(row.failed_rate.low), percent(row.failed_rate.high));
  for (std::string text :
       {std::to_string(row.trials), failed, mean_text(row.right), seconds(row.right_median), seconds(row.right_p90),
        mean_text(row.mended), std::to_string(row.flips), std::to_string(row.purges), std::to_string(row.false_flips),
        fmt::format("{:.2f}", row.right_hours)})
    cells.push_back(std::move(text));
  return cells;
}

}  // namespace

void print_rows(const Experiment& experiment, const std::vector<CellRow>& rows, std::ostream& out) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Axis& axis : experiment.axes) lines[0].push_back(as_line(axis.name));
  for (const char* title : {"trials", "failed [95 %]", "right after, s", "median", "p90", "mended after, s", "flips",
                            "purges", "false flips", "right hours"})
    lines[0].emplace_back(title);
  for (const CellRow& row : rows) lines.push_back(cells_of(row));
  std::vector<std::size_t> widths(lines[0].size());
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  for (const std::vector<std::string>& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i)
      text += i < experiment.axes.size() ? fmt::format("{:<{}}  ", line[i], widths[i])
                                         : fmt::format("{:>{}}  ", line[i], widths[i]);
    out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
  }
}

void check_axis_names(const Experiment& experiment) {
  const auto numbers = ordered_json::parse(rows_as_json({}, {CellRow()})).at(0);
  for (const Axis& axis : experiment.axes) {
    if (numbers.contains(as_utf8(axis.name)))
      throw std::runtime_error("the axis '" + as_line(axis.name) +
                               "' is called as one of the numbers of a row; give it another name");
  }
}

std::string rows_as_json(const Experiment& experiment, const std::vector<CellRow>& rows) {
  ordered_json list = ordered_json::array();
  for (const CellRow& cell : rows) {
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
    json["mean_s"] = or_null(of_command ? row.mended.mean : row.right.mean);
    json["median_s"] = or_null(of_command ? row.mended_median : row.right_median);
    json["p90_s"] = or_null(of_command ? row.mended_p90 : row.right_p90);
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
    json["kidnap_trials"] = row.kidnapped;
    json["kidnap_failed"] = share(row.kidnapped_failed, row.kidnapped);
    json["kidnap_mean_s"] = or_null(row.kidnapped_right.mean);
    json["usable_mean_s"] = or_null(row.usable.mean);
    list.push_back(std::move(json));
  }
  return list.dump(2) + '\n';
}

}  // namespace reorient
