// SPDX-License-Identifier: MIT
// A dot with its interval, as a strip that fits the row of a table.
#pragma once

#include <string_view>

#include "workbench/experiments/charts/markup.h"
#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/statistics/interval.h"

namespace reorient {

/// `interval`: the part beyond the axis is cut off and ends in an arrow.
void draw_interval(Markup& out, std::string_view description, const PlotAxis& axis, double value,
                   const Interval& interval, std::string_view style);

/// The axis of all strips of a column.
void draw_strip_axis(Markup& out, const PlotAxis& axis);

}  // namespace reorient
