// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "workbench/experiments/charts/interval_strip.h"
#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/report/figures.h"

namespace reorient {
namespace {

/// One line of a figure that is a table of strips.
struct StripRow {
  std::vector<std::string> names;
  std::string style;
  double value = 0.0;
  Interval interval;
  std::string text;  ///< the same in numbers
};

void draw_strips(Markup& out, const Report& report, const PlotAxis& axis, const std::vector<StripRow>& rows) {
  const Element scroll(out, "div", {{"class", "scroll"}});
  const Element table(out, "table", {{"class", "strips"}});
  {
    const Element head(out, "thead");
    const Element line(out, "tr");
    for (const Axis& one : report.experiment.axes) out.leaf("th", one.name, {{"scope", "col"}});
    {
      const Element cell(out, "th", {{"class", "strip-cell"}, {"scope", "col"}});
      out.text(axis.label);
    }
    out.leaf("th", "", {{"scope", "col"}});
  }
  const Element body(out, "tbody");
  for (const StripRow& row : rows) {
    const Element line(out, "tr");
    for (const std::string& name : row.names) out.leaf("th", name, {{"scope", "row"}});
    {
      const Element cell(out, "td", {{"class", "strip-cell"}});
      draw_interval(out, row.text, axis, row.value, row.interval, row.style);
    }
    out.leaf("td", row.text, {{"class", "reading"}});
  }
  const Element line(out, "tr", {{"class", "strip-axis"}});
  for (std::size_t i = 0; i < report.experiment.axes.size(); ++i) out.leaf("td", "");
  {
    const Element cell(out, "td", {{"class", "strip-cell"}});
    draw_strip_axis(out, axis);
  }
  out.leaf("td", "");
}

double false_flips_per_hour(const Row& row) { return row.false_flips / row.right_hours; }

/// Limits the axis, because one cell with few right hours would compress all others.
double highest_rate_shown(const std::vector<CellResults>& cells) {
  double largest = 0.0, least_high = INFINITY, most_high = 0.0;
  for (const CellResults& cell : cells) {
    if (cell.row.right_hours <= 0.0) continue;
    largest = std::max(largest, false_flips_per_hour(cell.row));
    least_high = std::min(least_high, cell.row.false_flip_rate.high);
    most_high = std::max(most_high, cell.row.false_flip_rate.high);
  }
  return std::max(1.5 * largest, std::min(most_high, 3.0 * least_high));
}

}  // namespace

void draw_failures(Markup& out, const Report& report) {
  const std::vector<Series> series = series_of(report);
  std::vector<StripRow> rows;
  for (std::size_t cell = 0; cell < report.cells.size(); ++cell) {
    const Row& row = report.cells[cell].row;
    if (row.disturbed == 0) continue;
    const double share = static_cast<double>(row.failed) / row.disturbed;
    const Interval in_percent{100.0 * row.failed_rate.low, 100.0 * row.failed_rate.high};
    rows.push_back({report.cells[cell].choices, series_of_cell(series, cell).style, share, row.failed_rate,
                    std::to_string(row.failed) + " of " + std::to_string(row.disturbed) + ", " + percent(share) + " " +
                        fixed(in_percent, 0)});
  }
  if (rows.empty()) return;
  const Element figure(out, "figure", {{"id", "failures"}});
  draw_strips(out, report, {"failed, %", 0.0, 1.0, 5, true}, rows);
  draw_caption(
      out, report,
      "Failures: the fraction of trials with a wrong belief at the start that did not become right in time and "
      "stay right. Dots: observed fractions. Bars: Wilson\u2019s 95 % interval.");
}

void draw_false_flips(Markup& out, const Report& report) {
  const std::vector<Series> series = series_of(report);
  std::vector<StripRow> rows;
  for (std::size_t cell = 0; cell < report.cells.size(); ++cell) {
    const Row& row = report.cells[cell].row;
    if (row.right_hours <= 0.0) continue;
    const double rate = false_flips_per_hour(row);
    rows.push_back({report.cells[cell].choices, series_of_cell(series, cell).style, rate, row.false_flip_rate,
                    std::to_string(row.false_flips) + " in " + fixed(row.right_hours, 2) + " h, " + fixed(rate, 1) +
                        " " + fixed(row.false_flip_rate, 1)});
  }
  if (rows.empty()) return;
  out.leaf("h2", "False flips");
  const Element figure(out, "figure", {{"id", "false-flips"}});
  constexpr int kTicks = 4;
  draw_strips(out, report,
              {"false flips per hour", 0.0, round_up_to_tick(highest_rate_shown(report.cells), kTicks), kTicks, false},
              rows);
  draw_caption(
      out, report,
      "Flips of a right belief, per hour in which it was right and the robot stood. Bars: Garwood\u2019s "
      "exact 95 % interval of a Poisson rate. An arrow: the interval exceeds the axis. Few hours give wide bars for "
      "any robot.");
}

}  // namespace reorient
