// SPDX-License-Identifier: MIT
#include "workbench/experiments/charts/plot.h"

#include <algorithm>

#include "workbench/experiments/charts/numbers.h"

namespace reorient {
namespace {

// Pixels, as all lengths here.
constexpr double kPlotWidth = 340.0, kPlotHeight = 210.0, kSquareHeight = 340.0, kLowHeight = 150.0;
constexpr double kLeft = 46.0, kRight = 10.0, kTop = 12.0, kBottom = 40.0;

std::string px(double length) { return fixed(length, 1); }

std::string tick_text(double tick, const PlotAxis& axis, int digits) {
  return axis.percent ? fixed(100.0 * tick, 0) : fixed(tick, digits);
}

double height_of(PlotShape shape) {
  return shape == PlotShape::square ? kSquareHeight : shape == PlotShape::low ? kLowHeight : kPlotHeight;
}

}  // namespace

std::vector<double> ticks(const PlotAxis& axis) {
  if (axis.linear > 0.0) return signed_ticks(axis.low, axis.high);
  return axis.logarithmic ? logarithmic_ticks(axis.low, axis.high) : ticks(axis.low, axis.high, axis.ticks);
}

Plot::Plot(Markup& out, std::string_view description, const PlotAxis& x, const PlotAxis& y, PlotShape shape)
    : out_(out),
      width_(kPlotWidth),
      height_(height_of(shape)),
      svg_(out, "svg",
           {{"viewBox", "0 0 " + px(width_) + " " + px(height_)},
            {"class", "plot"},
            {"role", "img"},
            {"aria-label", description}}),
      x_{x.low, x.high, kLeft, width_ - kRight, x.logarithmic, x.linear},
      y_{y.low, y.high, height_ - kBottom, kTop, y.logarithmic, y.linear} {
  draw_axes(x, y);
}

void Plot::draw_axes(const PlotAxis& x, const PlotAxis& y) {
  const std::vector<double> up = ticks(y), along = ticks(x);
  const std::string left = px(kLeft), right = px(width_ - kRight);
  for (const double tick : up) {
    const std::string at = px(y_(tick));
    out_.single("line", {{"class", "grid"}, {"x1", left}, {"x2", right}, {"y1", at}, {"y2", at}});
    out_.leaf("text", tick_text(tick, y, tick_digits(up)),
              {{"class", "tick end"}, {"x", px(kLeft - 6.0)}, {"y", px(y_(tick) + 4.0)}});
  }
  const std::string floor = px(y_.begin), below = px(y_.begin + 4.0);
  out_.single("line", {{"class", "axis"}, {"x1", left}, {"x2", right}, {"y1", floor}, {"y2", floor}});
  for (const double tick : along) {
    const std::string at = px(x_(tick));
    out_.single("line", {{"class", "axis"}, {"x1", at}, {"x2", at}, {"y1", floor}, {"y2", below}});
    out_.leaf("text", tick_text(tick, x, x.logarithmic ? tick_digits({tick}) : tick_digits(along)),
              {{"class", "tick middle"}, {"x", at}, {"y", px(y_.begin + 16.0)}});
  }
  out_.leaf("text", x.label, {{"class", "label middle"}, {"x", px((kLeft + width_) / 2.0)}, {"y", px(height_ - 7.0)}});
  const std::string middle = px((y_.begin + y_.end) / 2.0);
  out_.leaf("text", y.label,
            {{"class", "label middle"}, {"x", "11"}, {"y", middle}, {"transform", "rotate(-90 11 " + middle + ")"}});
}

PlotPoint Plot::place(const PlotPoint& point) const {
  return {x_(std::clamp(point.x, x_.low, x_.high)), y_(std::clamp(point.y, y_.low, y_.high))};
}

std::string Plot::path(const std::vector<PlotPoint>& points, bool backwards) const {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PlotPoint at = place(backwards ? points[points.size() - 1 - i] : points[i]);
    text.append(text.empty() ? "" : " ").append(px(at.x)).append(",").append(px(at.y));
  }
  return text;
}

void Plot::line(const std::vector<PlotPoint>& points, std::string_view style) {
  if (!points.empty()) out_.single("polyline", {{"class", "line " + std::string(style)}, {"points", path(points)}});
}

void Plot::band(const std::vector<PlotPoint>& low, const std::vector<PlotPoint>& high, std::string_view style) {
  if (low.empty()) return;
  out_.single("polygon", {{"class", "band " + std::string(style)}, {"points", path(low) + " " + path(high, true)}});
}

void Plot::stretch(double from, double to, std::string_view style) {
  const double begin = place({from, 0.0}).x, end = place({to, 0.0}).x;
  out_.single("rect", {{"class", style},
                       {"x", px(begin)},
                       {"y", px(y_.end)},
                       {"width", px(std::max(0.0, end - begin))},
                       {"height", px(y_.begin - y_.end)}});
}

void Plot::bar(double from, double to, std::string_view style) {
  constexpr double kHeight = 7.0;
  const double begin = place({from, 0.0}).x, end = place({to, 0.0}).x;
  out_.single("rect", {{"class", style},
                       {"x", px(begin)},
                       {"y", px((kTop - kHeight) / 2.0)},
                       {"width", px(std::max(0.0, end - begin))},
                       {"height", px(kHeight)}});
}

void Plot::moment(double x, std::string_view word) {
  const double at = place({x, 0.0}).x;
  const bool is_late = at > 0.75 * width_;
  out_.single("line", {{"class", "moment"}, {"x1", px(at)}, {"x2", px(at)}, {"y1", px(y_.begin)}, {"y2", px(y_.end)}});
  if (word.empty()) return;
  out_.leaf(
      "text", word,
      {{"class", is_late ? "tick end" : "tick"}, {"x", px(at + (is_late ? -4.0 : 4.0))}, {"y", px(y_.end + 9.0)}});
}

void Plot::end_mark(const PlotPoint& point, std::string_view style) {
  const PlotPoint at = place(point);
  constexpr double kHalf = 5.0;
  out_.single("line", {{"class", "line solid " + std::string(style)},
                       {"x1", px(at.x)},
                       {"x2", px(at.x)},
                       {"y1", px(at.y - kHalf)},
                       {"y2", px(at.y + kHalf)}});
}

std::vector<PlotPoint> as_steps(const std::vector<PlotPoint>& points, double until) {
  std::vector<PlotPoint> steps;
  for (const PlotPoint& point : points) {
    if (!steps.empty()) steps.push_back({point.x, steps.back().y});
    steps.push_back(point);
  }
  if (!steps.empty()) steps.push_back({until, steps.back().y});
  return steps;
}

}  // namespace reorient
