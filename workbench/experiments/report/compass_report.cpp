// SPDX-License-Identifier: MIT
#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/report/figures.h"
#include "workbench/experiments/report/roc_points.h"
#include "workbench/experiments/tables/compass_rows.h"

namespace reorient {
namespace {

std::string time_name(std::size_t time) {
  return kLookTimes[time] == 0.0 ? "one frame" : fixed(kLookTimes[time], 0) + " s of looking about";
}

/// The figure of one light and time, with a line for each method.
void draw_panel(Markup& out, std::span<const CompassRow> rows, const std::string& name,
                const std::vector<Series>& series, std::size_t time) {
  const Element panel(out, "div", {{"class", "panel"}});
  out.leaf("p", (name.empty() ? "" : name + ", ") + time_name(time), {{"class", "panel-name"}});
  std::string reading;
  for (const CompassRow& row : rows) {
    reading += (reading.empty() ? "" : "; ") + series[row.method].name + " " + fixed(row.figures[time].area, 3) + " " +
               fixed(row.figures[time].area_interval, 3);
  }
  {
    Plot plot(out, "ROC curves: " + reading, {"false alarms, % of right poses", 0.0, 1.0, 5, true},
              {"detected, % of mirrored poses", 0.0, 1.0, 5, true}, PlotShape::square);
    plot.line({{0.0, 0.0}, {1.0, 1.0}}, "chance");
    for (const CompassRow& row : rows) plot.line(as_points(row.figures[time].curve), series[row.method].style);
  }
  out.leaf("p", "area: " + reading, {{"class", "reading"}});
}

}  // namespace

void draw_compasses(Markup& out, const Report& report) {
  if (!have_looks(report.cells)) return;
  out.leaf("h2", "Room awareness and its peers");
  const Element figure(out, "figure", {{"id", "compasses"}});
  std::vector<Series> series;
  for (std::size_t i = 0; i < kCompassMethods.size(); ++i)
    series.push_back({std::string(kCompassMethods[i]), "s" + std::to_string(i), {}});
  draw_legend(out, series);
  {
    const Element panels(out, "div", {{"class", "panels"}});
    const std::vector<CompassRow> rows = compass_rows(report.experiment, report.cells);
    // Pooled rows come first: those of one choice of the last axis stand together.
    const std::size_t lights =
        report.experiment.axes.empty() ? 1 : with_usual_choices(report.experiment).axes.back().choices.size();
    for (std::size_t begin = 0; begin < std::min(rows.size(), lights * series.size()); begin += series.size()) {
      const std::string name = rows[begin].choices.empty()
                                   ? std::string()
                                   : report.experiment.axes.back().name + " " + rows[begin].choices.back();
      for (std::size_t time = 0; time < kLookTimes.size(); ++time)
        draw_panel(out, std::span(rows).subspan(begin, series.size()), name, series, time);
    }
  }
  draw_caption(out, report,
               "How well each method separates the mirrored pose from the pose, over all thresholds (ROC; dotted: "
               "chance), pooled over all other axes. Each period of looking around counts twice, once with the "
               "belief and once with the mirrored belief. In brackets: 95 %, bootstrap of whole trials.");
}

}  // namespace reorient
