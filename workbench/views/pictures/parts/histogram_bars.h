// A colour histogram as a bar chart (the paper's Fig. 3): the share of each colour upwards, how much that share varies
// downwards.
#pragma once

#include <array>
#include <functional>

#include "workbench/views/pictures/canvas/canvas.h"

namespace reorient::pictures {

/// Bin 0 is black, 1 white, then 2 + 4 * slice + quadrant: slices of Y from dark (0) to bright (2), quadrants
/// (Cb >= 128) + 2 * (Cr >= 128).
inline constexpr int kHistogramBins = 14;

struct HistogramBars {
  std::array<float, kHistogramBins> share{};      ///< in [0, 1], of the pixels
  std::array<float, kHistogramBins> deviation{};  ///< of that share: the square root of Eq. (2); 0 where unknown
};

/// The colour that stands for a bin: the middle of its part of the YCbCr space.
Color bin_color(int bin);

/// Where a point of the chart lies: `along` the bins from 0 to 1, `up` from -1 (deepest bar) over 0 (base) to 1
/// (highest).
using ChartPlace = std::function<Pixel(double along, double up)>;

/// Draws the bars. A share of `full_share` or more fills the height; a quarter of it as deviation fills the depth.
void draw_histogram(Canvas& canvas, const HistogramBars& bars, const ChartPlace& place, double full_share);

/// Upright in `box`, with `below` of its height for the deviations (0: none are drawn).
void draw_histogram(Canvas& canvas, const HistogramBars& bars, const Box& box, double below, double full_share);

/// The legend: every bin's colour, the quadrants of Cb and Cr in three slices of Y, black and white. Takes 276 x 128
/// pixels.
void draw_bin_legend(Canvas& canvas, const Pixel& top_left);

}  // namespace reorient::pictures
