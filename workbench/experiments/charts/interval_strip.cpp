// SPDX-License-Identifier: MIT
#include "workbench/experiments/charts/interval_strip.h"

#include <algorithm>
#include <string>

#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/charts/scale.h"

namespace reorient {
namespace {

constexpr double kStripWidth = 300.0, kStripHeight = 22.0, kStripMargin = 12.0;  // pixels

std::string pixels(double length) { return fixed(length, 1); }

Scale strip_scale(const PlotAxis& axis) { return {axis.low, axis.high, kStripMargin, kStripWidth - kStripMargin}; }

void draw_grid(Markup& out, const PlotAxis& axis) {
  for (const double tick : ticks(axis.low, axis.high, axis.ticks)) {
    const std::string at = pixels(strip_scale(axis)(tick));
    out.single("line", {{"class", "grid"}, {"x1", at}, {"x2", at}, {"y1", "0"}, {"y2", pixels(kStripHeight)}});
  }
}

}  // namespace

void draw_interval(Markup& out, std::string_view description, const PlotAxis& axis, double value,
                   const Interval& interval, std::string_view style) {
  const std::string series(style);
  const Element svg(out, "svg",
                    {{"viewBox", "0 0 " + pixels(kStripWidth) + " " + pixels(kStripHeight)},
                     {"class", "strip"},
                     {"role", "img"},
                     {"aria-label", description}});
  draw_grid(out, axis);
  const Scale scale = strip_scale(axis);
  const bool is_cut = !(interval.high <= axis.high);
  const double low = scale(std::clamp(interval.low, axis.low, axis.high)),
               high = scale(std::min(interval.high, axis.high));
  const std::string middle = pixels(kStripHeight / 2.0);
  out.single(
      "line",
      {{"class", "whisker " + series}, {"x1", pixels(low)}, {"x2", pixels(high)}, {"y1", middle}, {"y2", middle}});
  if (is_cut)
    out.single("polyline",
               {{"class", "line solid " + series},
                {"points", pixels(high) + "," + pixels(kStripHeight / 2.0 - 4.0) + " " + pixels(high + 5.0) + "," +
                               middle + " " + pixels(high) + "," + pixels(kStripHeight / 2.0 + 4.0)}});
  out.single("circle", {{"class", "dot " + series},
                        {"cx", pixels(scale(std::clamp(value, axis.low, axis.high)))},
                        {"cy", middle},
                        {"r", "4.5"}});
}

void draw_strip_axis(Markup& out, const PlotAxis& axis) {
  const Element svg(out, "svg",
                    {{"viewBox", "0 0 " + pixels(kStripWidth) + " " + pixels(kStripHeight)},
                     {"class", "strip"},
                     {"aria-hidden", "true"}});
  const std::vector<double> all = ticks(axis.low, axis.high, axis.ticks);
  for (const double tick : all)
    out.leaf("text", axis.percent ? fixed(100.0 * tick, 0) : fixed(tick, tick_digits(all)),
             {{"class", "tick middle"}, {"x", pixels(strip_scale(axis)(tick))}, {"y", pixels(kStripHeight - 6.0)}});
}

}  // namespace reorient
