// SPDX-License-Identifier: MIT
// The figures of a report, each with title, explanation and provenance.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/experiments/charts/markup.h"
#include "workbench/experiments/report/report.h"

namespace reorient {

// Fractions and rates, a dot with its interval for each cell.
void draw_failures(Markup& out, const Report& report);
void draw_false_flips(Markup& out, const Report& report);

/// Detection and false flips along the last axis whose choices are at least three numbers of one unit ("30 %"), such
/// as the strength of a room's symmetry; writes nothing without such an axis. Pools the rooms.
void draw_ladder(Markup& out, const Report& report);

/// The fraction of right beliefs over time: a line for each series, a picture for each group.
void draw_time_to_right(Markup& out, const Report& report);

/// How well the confidences separate wrong beliefs from right ones: a line for each series.
void draw_roc(Markup& out, const Report& report);

/// Calibration of the evidence: a line for each series.
void draw_reliability(Markup& out, const Report& report);

/// How well room awareness and its peers distinguish a pose from the mirrored pose; writes nothing if no trial compared
/// them.
void draw_compasses(Markup& out, const Report& report);

/// The confidences and the evidence of the best, the median, the worst and the failed trials of each series.
void draw_confidences(Markup& out, const Report& report);

// Parts that the figures share.

struct LegendEntry {
  std::string name;
  std::string style;     ///< class of its color and dash
  bool is_area = false;  ///< false: a line
};
void draw_entries(Markup& out, const std::vector<LegendEntry>& entries);
/// Color, dash and name of each series.
void draw_legend(Markup& out, const std::vector<Series>& series);
/// The end of a figure: its caption, and a line with the provenance.
void draw_caption(Markup& out, const Report& report, std::string_view caption);

}  // namespace reorient
