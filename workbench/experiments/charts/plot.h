// SPDX-License-Identifier: MIT
// Lines over an abscissa and an ordinate, as an SVG picture of its own. Colors and dashes are the page's: classes s0,
// s1, ... name the series (report/style).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/experiments/charts/markup.h"
#include "workbench/experiments/charts/scale.h"

namespace reorient {

struct PlotAxis {
  std::string label;
  double low = 0.0;
  double high = 1.0;
  int ticks = 5;             ///< approximate number
  bool percent = false;      ///< numbers are fractions, shown in %
  bool logarithmic = false;  ///< both bounds above 0
  double linear = 0.0;       ///< as that of Scale, with bounds on both sides of 0
};

enum class PlotShape { wide, square, low };

/// The ticks of an axis.
std::vector<double> ticks(const PlotAxis& axis);

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
};

/// Open while this object exists. Later shapes cover earlier ones. Parts beyond the axes are cut off.
class Plot {
 public:
  /// `description`: alternative text for screen readers.
  Plot(Markup& out, std::string_view description, const PlotAxis& x, const PlotAxis& y,
       PlotShape shape = PlotShape::wide);

  void line(const std::vector<PlotPoint>& points, std::string_view style);
  /// The area between two lines with the same number of points.
  void band(const std::vector<PlotPoint>& low, const std::vector<PlotPoint>& high, std::string_view style);
  /// An interval of the abscissa, over the whole height.
  void stretch(double from, double to, std::string_view style);
  /// An interval of the abscissa, as a bar above the axes.
  void bar(double from, double to, std::string_view style);
  /// A vertical line with a word at its top; without a word only the line.
  void moment(double x, std::string_view word);
  /// A short stroke across the end of a line: the curve is unknown beyond it.
  void end_mark(const PlotPoint& point, std::string_view style);

 private:
  void draw_axes(const PlotAxis& x, const PlotAxis& y);
  std::string path(const std::vector<PlotPoint>& points, bool backwards = false) const;
  PlotPoint place(const PlotPoint& point) const;

  Markup& out_;
  double width_, height_;
  Element svg_;
  Scale x_, y_;
};

/// As a curve that keeps its value until the next point, up to `until`.
std::vector<PlotPoint> as_steps(const std::vector<PlotPoint>& points, double until);

}  // namespace reorient
