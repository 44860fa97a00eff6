// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/report/figures.h"
#include "workbench/experiments/report/roc_points.h"
#include "workbench/experiments/statistics/calibration.h"
#include "workbench/experiments/statistics/roc.h"
#include "workbench/experiments/statistics/times.h"

namespace reorient {
namespace {

/// The range of times: from below the first event to the largest limit.
PlotAxis time_axis(const Report& report) {
  constexpr double kLeast = 0.1;  // s
  PlotAxis axis{"time, s", 1.0, 2.0, 5, false, true};
  for (std::size_t cell = 0; cell < report.cells.size(); ++cell) {
    const std::vector<CensoredTime> times = times_until_right(report.cells[cell].trials);
    if (!times.empty()) axis.high = std::max(axis.high, limit_of(report, cell));
    for (const CensoredTime& time : times) {
      if (time.happened) axis.low = std::min(axis.low, std::max(kLeast, 0.8 * time.seconds));
    }
  }
  return axis;
}

void draw_curve(Plot& plot, const std::vector<CensoredTime>& times, const PlotAxis& axis, const std::string& style) {
  double until = axis.low;
  bool is_censored = false;
  for (const CensoredTime& time : times) {
    until = std::max(until, std::min(time.seconds, axis.high));
    is_censored |= !time.happened;
  }
  std::vector<PlotPoint> share{{axis.low, 0.0}}, low{{axis.low, 0.0}}, high{{axis.low, 0.0}};
  if (!is_censored) until = axis.high;
  double band_until = until;
  for (const SurvivalStep& step : kaplan_meier(times)) {
    share.push_back({step.seconds, 1.0 - step.share});
    if (step.share <= 0.0) {  // no trials remain
      band_until = step.seconds;
      break;
    }
    low.push_back({step.seconds, 1.0 - step.band.high});
    high.push_back({step.seconds, 1.0 - step.band.low});
  }
  plot.band(as_steps(low, band_until), as_steps(high, band_until), style);
  plot.line(as_steps(share, until), style);
  if (is_censored) plot.end_mark({until, share.back().y}, style);
}

/// The cells of both.
std::vector<std::size_t> cells_in_both(const Series& series, const CellGroup& group) {
  std::vector<std::size_t> cells;
  std::copy_if(group.cells.begin(), group.cells.end(), std::back_inserter(cells), [&](std::size_t cell) {
    return std::find(series.cells.begin(), series.cells.end(), cell) != series.cells.end();
  });
  return cells;
}

/// The corrected beliefs of each series: "default 8 of 8, none 0 of 8".
std::string count_text(const Report& report, const std::vector<Series>& picture, const CellGroup& group) {
  std::string text;
  for (const Series& one : picture) {
    for (const std::size_t cell : cells_in_both(one, group)) {
      const std::vector<CensoredTime> times = times_until_right(report.cells[cell].trials);
      if (times.empty()) continue;
      const auto right = std::count_if(times.begin(), times.end(), [](const auto& time) { return time.happened; });
      text +=
          (text.empty() ? "" : ", ") + one.name + " " + std::to_string(right) + " of " + std::to_string(times.size());
    }
  }
  return text;
}

ScoredSamples samples_of(const Report& report, const Series& series) {
  ScoredSamples samples;
  for (const std::size_t cell : series.cells) add_scores(samples, report.cells[cell].trials);
  return samples;
}

}  // namespace

std::vector<PlotPoint> as_points(const std::vector<RocPoint>& curve) {
  constexpr double kVisible = 0.002;
  std::vector<PlotPoint> points;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const PlotPoint point{curve[i].false_positives, curve[i].true_positives};
    const bool is_end = i == 0 || i + 1 == curve.size();
    if (is_end || point.x - points.back().x > kVisible || point.y - points.back().y > kVisible) points.push_back(point);
  }
  return points;
}

void draw_time_to_right(Markup& out, const Report& report) {
  const bool has_any = std::any_of(report.cells.begin(), report.cells.end(),
                                   [](const CellResults& cell) { return cell.row.disturbed > 0; });
  if (!has_any) return;
  out.leaf("h2", "How soon a belief is right again");
  const Element figure(out, "figure", {{"id", "times"}});
  const std::vector<Series> series = series_of(report);
  std::vector<Series> drawn;
  std::copy_if(series.begin(), series.end(), std::back_inserter(drawn), [&](const Series& one) {
    return std::any_of(one.cells.begin(), one.cells.end(),
                       [&](std::size_t cell) { return report.cells[cell].row.disturbed > 0; });
  });
  const std::vector<std::vector<Series>> pictures = pictures_of(drawn);
  if (pictures.size() == 1) draw_legend(out, pictures.front());
  const PlotAxis axis = time_axis(report);
  {
    const Element panels(out, "div", {{"class", "panels"}});
    for (const CellGroup& group : groups_of(report)) {
      for (const std::vector<Series>& picture : pictures) {
        const std::string counts = count_text(report, picture, group);
        if (counts.empty()) continue;
        const Element panel(out, "div", {{"class", "panel"}});
        if (!group.name.empty()) out.leaf("p", group.name, {{"class", "panel-name"}});
        if (pictures.size() > 1) draw_legend(out, picture);
        {
          Plot plot(out, "share of right beliefs over time: " + counts, axis,
                    {"belief is right, %", 0.0, 1.0, 5, true});
          for (const Series& one : picture) {
            for (const std::size_t cell : cells_in_both(one, group)) {
              const std::vector<CensoredTime> times = times_until_right(report.cells[cell].trials);
              if (!times.empty()) draw_curve(plot, times, axis, one.style);
            }
          }
        }
        out.leaf("p", "right: " + counts, {{"class", "reading"}});
      }
    }
  }
  draw_caption(
      out, report,
      "Time until the belief is right and stays so (Kaplan and Meier), of trials with a wrong belief at the start. "
      "Shaded: 95 %, point by point (log-log, Greenwood\u2019s variance), while trials remain. A stroke at the end of "
      "a "
      "line: trials "
      "that were not right by then are censored. The abscissa is logarithmic.");
}

void draw_reliability(Markup& out, const Report& report) {
  const bool has_any = std::any_of(report.cells.begin(), report.cells.end(),
                                   [](const CellResults& cell) { return cell.row.calibration_samples > 0; });
  if (!has_any) return;
  out.leaf("h2", "What the evidence is worth");
  const Element figure(out, "figure", {{"id", "reliability"}});
  const std::vector<std::vector<Series>> pictures = pictures_of(series_of(report));
  if (pictures.size() == 1) draw_legend(out, pictures.front());
  {
    const Element panels(out, "div", {{"class", "panels"}});
    for (const std::vector<Series>& picture : pictures) {
      const Element panel(out, "div", {{"class", "panel"}});
      if (pictures.size() > 1) draw_legend(out, picture);
      std::vector<std::pair<std::string, std::vector<PlotPoint>>> lines;
      std::string reading;
      for (const Series& one : picture) {
        std::vector<TrialResult> trials;
        for (const std::size_t cell : one.cells)
          trials.insert(trials.end(), report.cells[cell].trials.begin(), report.cells[cell].trials.end());
        const std::vector<CalibrationBin> bins = calibration_of(trials);
        if (bins.empty()) continue;
        std::vector<PlotPoint> points;
        int samples = 0;
        for (const CalibrationBin& bin : bins) {
          constexpr int kFewest = 20;  // samples; fewer are too noisy
          samples += bin.samples;
          if (bin.samples >= kFewest) points.push_back({bin.certainty(), bin.accuracy()});
        }
        reading.append(reading.empty() ? "" : "; ").append(one.name).append(": expected calibration error ");
        reading.append(fixed(calibration_error(bins), 4))
            .append(" (")
            .append(std::to_string(samples))
            .append(" samples)");
        lines.emplace_back(one.style, std::move(points));
      }
      {
        Plot plot(out, "reliability: " + reading, {"probability by the evidence, %", 0.5, 1.0, 5, true},
                  {"right, %", 0.5, 1.0, 5, true}, PlotShape::square);
        plot.line({{0.5, 0.5}, {1.0, 1.0}}, "chance");
        for (const auto& [style, points] : lines) plot.line(points, style);
      }
      out.leaf("p", reading, {{"class", "reading"}});
    }
  }
  draw_caption(out, report,
               "How often the more probable of the two poses is the right one, over its probability according to the "
               "evidence (dotted: perfect calibration). Two samples a second while the room was usable and the belief "
               "was right or mirrored; samples of one trial depend on each other.");
}

void draw_roc(Markup& out, const Report& report) {
  struct Curve {
    std::string reading;
    std::vector<RocPoint> points;  ///< empty if all beliefs were right, or all wrong
  };
  const std::vector<Series> series = series_of(report);
  std::map<std::string, Curve> curves;  // by the series' name
  for (const Series& one : series) {
    ScoredSamples samples = samples_of(report, one);
    const std::string wrong = std::to_string(samples.wrong.size()), right = std::to_string(samples.right.size());
    Curve& curve = curves[one.name];
    curve.points = roc_curve(std::move(samples.wrong), std::move(samples.right));
    curve.reading =
        one.name + (curve.points.empty() ? ": no curve (" : ": area " + fixed(area_below(curve.points), 3) + " (");
    curve.reading.append(wrong).append(" wrong, ").append(right).append(" right)");
  }
  if (std::all_of(curves.begin(), curves.end(), [](const auto& one) { return one.second.points.empty(); })) return;
  out.leaf("h2", "Detection by the confidences");
  const Element figure(out, "figure", {{"id", "roc"}});
  const std::vector<std::vector<Series>> pictures = pictures_of(series);
  if (pictures.size() == 1) draw_legend(out, pictures.front());
  {
    const Element panels(out, "div", {{"class", "panels"}});
    for (const std::vector<Series>& picture : pictures) {
      const Element panel(out, "div", {{"class", "panel"}});
      if (pictures.size() > 1) draw_legend(out, picture);
      std::string reading;
      for (const Series& one : picture) reading += (reading.empty() ? "" : "; ") + curves[one.name].reading;
      {
        Plot plot(out, "ROC curves: " + reading, {"false alarms, % of right beliefs", 0.0, 1.0, 5, true},
                  {"detected, % of wrong beliefs", 0.0, 1.0, 5, true}, PlotShape::square);
        plot.line({{0.0, 0.0}, {1.0, 1.0}}, "chance");
        for (const Series& one : picture) {
          const std::vector<RocPoint>& points = curves[one.name].points;
          if (!points.empty()) plot.line(as_points(points), one.style);
        }
      }
      out.leaf("p", reading, {{"class", "reading"}});
    }
  }
  draw_caption(out, report,
               "How well the difference of the confidences, opposite minus current, separates wrong beliefs from right "
               "ones, over all thresholds (ROC; dotted: chance). Two samples a second from all trials of a choice; "
               "samples of one trial depend on each other.");
}

}  // namespace reorient
