// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/confidence_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/pictures/parts/evidence_track.h"
#include "workbench/views/pictures/parts/legend.h"
#include "workbench/views/pictures/parts/status_color.h"

namespace reorient::pictures {
namespace {

constexpr int kPlotWidth = 1500;
constexpr double kLeft = 196.0;  // space for the names of the lanes
constexpr double kRight = kPlotWidth - 36.0;
constexpr double kTop = 176.0;     // below title, legend and names of commands
constexpr double kCurves = 400.0;  // height
constexpr EvidenceTrack kEvidence{kTop + kCurves + 30.0, 150.0};
constexpr double kLanesTop = kEvidence.top + kEvidence.height + 16.0;
constexpr double kLane = 28.0;
constexpr int kLabelLanes = 2;
constexpr double kRefusedApart = 5.0;  // pixels; refusals in successive frames are drawn as one

struct LaneStyle {
  const char* name;
  Color color;
  bool shades_curves;
};

LaneStyle lane_style(RunCondition condition) {
  switch (condition) {
    case RunCondition::training:
      return {"training", {64, 160, 92}, false};
    case RunCondition::evaluation_paused:
      return {"evaluation paused", palette::cluster, false};
    case RunCondition::belief_reflected:
      return {"belief mirrored", palette::opposite, false};
    case RunCondition::lifted:
      return {"lifted", {126, 87, 194}, true};
    case RunCondition::down:
      return {"fallen", {230, 126, 34}, true};
  }
  return {"", palette::cluster, false};
}

TimeAxis time_axis(const ConfidencePlot& plot) {
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  const auto include = [&](double time) {
    if (!(std::abs(time) < 1e9)) return;  // excludes NaN, too
    first = std::min(first, time);
    last = std::max(last, time);
  };
  for (const ConfidencePoint& sample : plot.samples) include(sample.time);
  if (plot.samples.empty()) {
    for (const CommandMark& mark : plot.commands) include(mark.time);
    for (const ConditionInterval& interval : plot.conditions) {
      include(interval.from);
      include(interval.to);
    }
  }
  if (first > last) return {0.0, 1.0, kLeft, kRight};
  return {first, std::max(last, first + 1.0), kLeft, kRight};
}

// A step of 1, 2 or 5 times a power of ten, with at most `most` ticks.
double tick_step(double range, int most) {
  double step = std::pow(10.0, std::floor(std::log10(range / most)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (range / step <= most) break;
    step *= factor;
  }
  return step;
}

double confidence_y(double confidence) { return kTop + (1.0 - std::clamp(confidence, -0.02, 1.02)) * kCurves; }

void draw_axes(Canvas& canvas, const TimeAxis& axis, double bottom) {
  const TextStyle label{.size = 18.0, .color = palette::faint_ink, .align = Align::right};
  for (int i = 0; i <= 4; ++i) {
    const double y = confidence_y(i / 4.0);
    canvas.line({kLeft, y}, {kRight, y}, palette::grid, 1.0);
    char words[16];
    std::snprintf(words, sizeof words, "%.2f", i / 4.0);
    canvas.text({kLeft - 10.0, y + 6.0}, words, label);
  }
  TextStyle middle = label;
  middle.align = Align::center;
  const double step = tick_step(axis.last - axis.first, 12);
  for (int i = 0; i <= 14; ++i) {
    const double time = (std::ceil(axis.first / step - 1e-9) + i) * step;
    if (time > axis.last + 1e-9) break;
    canvas.line({axis.x(time), kTop}, {axis.x(time), bottom}, palette::grid, 1.0);
    char words[32];
    std::snprintf(words, sizeof words, step < 1.0 ? "%.1f" : "%.0f", time);
    canvas.text({axis.x(time), bottom + 24.0}, words, middle);
  }
  canvas.text({(kLeft + kRight) / 2.0, bottom + 54.0}, "time in s", {.size = 20.0, .align = Align::center});
  canvas.text({kLeft - 10.0, kTop - 24.0}, "confidence", {.size = 20.0, .align = Align::right});
}

/// The box between two times; empty if they do not overlap with the axis.
std::optional<Box> box_between(const TimeAxis& axis, const ConditionInterval& interval, double top, double height) {
  if (!(interval.to > interval.from) || interval.to < axis.first || interval.from > axis.last) return std::nullopt;
  const double left = axis.x(std::max(interval.from, axis.first));
  const double right = axis.x(std::min(interval.to, axis.last));
  return Box{left, top, std::max(right - left, 1.0), height};
}

std::vector<RunCondition> lanes_of(const ConfidencePlot& plot) {
  std::vector<RunCondition> lanes;
  for (const RunCondition condition : {RunCondition::training, RunCondition::evaluation_paused,
                                       RunCondition::belief_reflected, RunCondition::lifted, RunCondition::down}) {
    const auto is_it = [&](const ConditionInterval& interval) { return interval.condition == condition; };
    if (std::any_of(plot.conditions.begin(), plot.conditions.end(), is_it)) lanes.push_back(condition);
  }
  return lanes;
}

void shade_curves(Canvas& canvas, const TimeAxis& axis, const ConfidencePlot& plot) {
  for (const ConditionInterval& interval : plot.conditions) {
    const LaneStyle style = lane_style(interval.condition);
    const auto box = box_between(axis, interval, kTop, kCurves);
    if (box && style.shades_curves) canvas.fill_box(*box, style.color.with_opacity(0.16));
  }
}

void draw_lanes(Canvas& canvas, const TimeAxis& axis, const ConfidencePlot& plot,
                const std::vector<RunCondition>& lanes) {
  double top = kLanesTop + kLane;
  for (const RunCondition condition : lanes) {
    const LaneStyle style = lane_style(condition);
    canvas.text({kLeft - 10.0, top + 17.0}, style.name, {.size = 17.0, .align = Align::right});
    canvas.fill_box({kLeft, top + 2.0, kRight - kLeft, kLane - 8.0}, palette::empty_plate);
    for (const ConditionInterval& interval : plot.conditions) {
      if (interval.condition != condition) continue;
      if (const auto box = box_between(axis, interval, top + 2.0, kLane - 8.0))
        canvas.fill_box(*box, style.color.with_opacity(0.75));
    }
    top += kLane;
  }
}

/// A lane whose color is the status, with its name where there is space.
void draw_status(Canvas& canvas, const TimeAxis& axis, const ConfidencePlot& plot) {
  canvas.text({kLeft - 10.0, kLanesTop + 17.0}, "room", {.size = 17.0, .align = Align::right});
  canvas.fill_box({kLeft, kLanesTop + 2.0, kRight - kLeft, kLane - 8.0}, palette::empty_plate);
  const std::vector<ConfidencePoint>& samples = plot.samples;
  for (std::size_t i = 0, next = 0; i < samples.size(); i = next) {
    while (next < samples.size() && samples[next].status == samples[i].status) ++next;
    const double left = axis.x(samples[i].time), right = axis.x(samples[std::min(next, samples.size() - 1)].time);
    if (!(right >= left)) continue;  // a time that is not a number
    canvas.fill_box({left, kLanesTop + 2.0, std::max(right - left, 1.0), kLane - 8.0}, status_color(samples[i].status));
    const TextStyle style{.size = 15.0, .align = Align::center};
    const std::string name(to_string(samples[i].status));
    if (Canvas::text_width(name, style) + 8.0 < right - left)
      canvas.text({(left + right) / 2.0, kLanesTop + 17.0}, name, style);
  }
}

void draw_commands(Canvas& canvas, const TimeAxis& axis, const ConfidencePlot& plot, double bottom) {
  std::array<double, kLabelLanes> lane_ends;
  lane_ends.fill(-1e9);
  double last_refusal = -1e9;
  for (const CommandMark& mark : plot.commands) {
    if (!axis.contains(mark.time)) continue;
    const double x = axis.x(mark.time);
    if (!mark.granted) {
      const bool again = std::abs(x - last_refusal) < kRefusedApart;
      last_refusal = x;
      if (again) continue;
    }
    const TextStyle style{.size = 19.0,
                          .color = mark.granted ? palette::ink : palette::faint_ink,
                          .align = Align::center,
                          .bold = mark.granted};
    const std::string label = shortened(mark.label, 240.0, style);
    const double half = Canvas::text_width(label, style) / 2.0;
    const double center = std::clamp(x, kLeft + half - 20.0, kRight - half + 20.0);
    double line_top = kTop;
    for (std::size_t lane = 0; lane < lane_ends.size(); ++lane) {
      if (center - half < lane_ends[lane] + 12.0) continue;
      lane_ends[lane] = center + half;
      const double baseline = kTop - 12.0 - 27.0 * static_cast<double>(lane);
      canvas.text({center, baseline}, label, style);
      line_top = baseline + 6.0;
      break;
    }
    // A label in the upper lane leaves the line of the lower lane free.
    const Pixel top(x, std::max(line_top, kTop - 6.0));
    if (mark.granted) {
      canvas.line(top, {x, bottom}, palette::ink, 2.0);
    } else {
      canvas.dashed_line(top, {x, bottom}, palette::faint_ink, 1.5, 6.0);
    }
  }
}

std::vector<LegendEntry> entries(const ConfidencePlot& plot) {
  const auto curves = [](Color color) {
    return [color](Canvas& canvas, const Pixel& center) {
      canvas.fill_box({center.x() - 16.0, center.y() - 7.0, 32.0, 14.0}, color.with_opacity(0.25));
      canvas.line(center - Pixel(16.0, 0.0), center + Pixel(16.0, 0.0), color, 3.5);
    };
  };
  std::vector<LegendEntry> list;
  if (!plot.samples.empty()) {
    list.push_back({curves(palette::belief), "believed pose (pale: raw)"});
    list.push_back({curves(palette::opposite), "mirrored pose"});
    list.push_back(line_entry(palette::evidence, 3.0, "evidence (log-odds)"));
  }
  if (has_threshold(plot.samples)) list.push_back(threshold_entry());
  const auto dashed = [](Canvas& canvas, const Pixel& center) {
    canvas.dashed_line(center - Pixel(16.0, 0.0), center + Pixel(16.0, 0.0), palette::faint_ink, 1.5, 6.0);
  };
  const auto refused = [](const CommandMark& mark) { return !mark.granted; };
  if (!std::all_of(plot.commands.begin(), plot.commands.end(), refused))
    list.push_back(line_entry(palette::ink, 2.0, "command"));
  if (std::any_of(plot.commands.begin(), plot.commands.end(), refused)) list.push_back({dashed, "refused"});
  return list;
}

}  // namespace

ConfidencePlot confidence_plot_of(const RunHistory& history) {
  ConfidencePlot plot{history.points(), {}, history.intervals()};
  for (const reorient::CommandMark& mark : history.commands())
    plot.commands.push_back({mark.time, short_name(mark.reorientation), mark.granted});
  return plot;
}

Picture draw_confidence_plot(const ConfidencePlot& plot) {
  const TimeAxis axis = time_axis(plot);
  const std::vector<RunCondition> lanes = lanes_of(plot);
  const double bottom = kLanesTop + kLane * static_cast<double>(1 + lanes.size());
  Canvas canvas(kPlotWidth, static_cast<int>(bottom + 76.0));

  canvas.text({36.0, 54.0}, "Confidences and evidence for the believed and the mirrored pose",
              {.size = 28.0, .bold = true});
  draw_legend_rows(canvas, {32.0, 74.0, kPlotWidth - 64.0, 34.0}, entries(plot));
  draw_axes(canvas, axis, bottom);
  draw_evidence_axis(canvas, axis, kEvidence);
  shade_curves(canvas, axis, plot);
  draw_status(canvas, axis, plot);
  draw_lanes(canvas, axis, plot, lanes);
  const Box curves{kLeft, kTop - 12.0, kRight - kLeft + 2.0, kCurves + 24.0};
  canvas.within(curves, [&] {
    draw_curve(canvas, axis, plot.samples, &ConfidencePoint::raw_opposite, confidence_y,
               palette::opposite.with_opacity(0.3), 1.0);
    draw_curve(canvas, axis, plot.samples, &ConfidencePoint::raw_current, confidence_y,
               palette::belief.with_opacity(0.3), 1.0);
    draw_curve(canvas, axis, plot.samples, &ConfidencePoint::opposite, confidence_y, palette::opposite, 3.5);
    draw_curve(canvas, axis, plot.samples, &ConfidencePoint::current, confidence_y, palette::belief, 3.5);
  });
  draw_evidence(canvas, axis, kEvidence, plot.samples);
  draw_commands(canvas, axis, plot, kEvidence.top + kEvidence.height);
  return canvas.finish();
}

}  // namespace reorient::pictures
