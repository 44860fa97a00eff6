// SPDX-License-Identifier: MIT
// Color histograms as bar charts on a canvas, and the legend of their colors.
#pragma once

#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/scene/histogram.h"

namespace reorient::pictures {

void draw_histogram(Canvas& canvas, const scene::HistogramBars& bars, const scene::ChartPlace& place,
                    double full_share);

/// The legend: every bin's color, the quadrants of Cb and Cr in three slices of Y, black and white. Takes 276 x 128
/// pixels.
void draw_bin_legend(Canvas& canvas, const Pixel& top_left);

}  // namespace reorient::pictures
