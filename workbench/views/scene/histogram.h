// SPDX-License-Identifier: MIT
// A color histogram as a bar chart (the paper's Fig. 3): the fraction of each color upward, its deviation downward.
#pragma once

#include <array>
#include <functional>

#include "workbench/views/scene/shapes.h"

namespace reorient::scene {

/// Bin 0 is black, 1 white, then 2 + 4 * slice + quadrant: slices of Y from dark (0) to bright (2), quadrants
/// (Cb >= 128) + 2 * (Cr >= 128).
inline constexpr int kHistogramBins = 14;

struct HistogramBars {
  std::array<float, kHistogramBins> share{};      ///< fraction of the pixels in [0, 1]
  std::array<float, kHistogramBins> deviation{};  ///< its standard deviation, the root of Eq. (2); 0 if unknown
};

/// The color that represents a bin: the middle of its part of the YCbCr space.
Color bin_color(int bin);

/// Position of a point of the chart: `along` the bins from 0 to 1, `up` from -1 (deepest bar) over 0 (base) to 1
/// (highest).
using ChartPlace = std::function<Eigen::Vector2d(double along, double up)>;

/// Appends the bars and their base line. A fraction of `full_share` or more fills the height; a deviation of a quarter
/// of it fills the depth.
void add_histogram(const HistogramBars& bars, const ChartPlace& place, double full_share, double line_thickness,
                   std::vector<Shape<Eigen::Vector2d>>& shapes);

/// An upright chart between two corners in an image. The fraction `below` of its height is for the deviations.
ChartPlace upright_chart(const Eigen::Vector2d& top_left, const Eigen::Vector2d& bottom_right, double below = 0.0);

}  // namespace reorient::scene
