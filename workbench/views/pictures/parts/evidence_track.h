// SPDX-License-Identifier: MIT
// Curves over time, and the evidence with its thresholds.
#pragma once

#include <functional>
#include <span>

#include "workbench/run/run_history.h"
#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/pictures/parts/legend.h"

namespace reorient::pictures {

struct TimeAxis {
  double first = 0.0;  ///< s
  double last = 1.0;
  double left = 0.0;  ///< pixels
  double right = 1.0;

  double x(double time) const { return left + (time - first) / (last - first) * (right - left); }
  bool contains(double time) const { return time >= first && time <= last; }
};

/// `y_of`: the pixel of a value. A value that is not finite leaves a gap.
void draw_curve(Canvas& canvas, const TimeAxis& axis, std::span<const ConfidencePoint> samples,
                double ConfidencePoint::*value, const std::function<double(double)>& y_of, Color color,
                double thickness);

/// Position of the evidence in a plot.
struct EvidenceTrack {
  double top = 0.0;  ///< pixels
  double height = 100.0;

  /// Logarithmic at both ends, so that a decision is visible beside the evidence of a well-known room.
  double y(double evidence) const;
};

void draw_evidence_axis(Canvas& canvas, const TimeAxis& axis, const EvidenceTrack& track);

/// The evidence as a line, the area to zero in the color of the pose that it supports, and the thresholds, dashed.
void draw_evidence(Canvas& canvas, const TimeAxis& axis, const EvidenceTrack& track,
                   std::span<const ConfidencePoint> samples);

bool has_threshold(std::span<const ConfidencePoint> samples);
LegendEntry threshold_entry();

}  // namespace reorient::pictures
