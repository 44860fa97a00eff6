// SPDX-License-Identifier: MIT
#include "workbench/views/scene/histogram.h"

#include <algorithm>
#include <cmath>

namespace reorient::scene {

Color to_color(double luma, double cb, double cr) {
  const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); };
  const double y = std::clamp(luma, 0.0, 255.0);
  const double blue = std::clamp(cb, 0.0, 255.0) - 128.0, red = std::clamp(cr, 0.0, 255.0) - 128.0;
  return {byte(y + 1.402 * red), byte(y - 0.344136 * blue - 0.714136 * red), byte(y + 1.772 * blue)};
}

Color evidence_color(double log_odds) {
  if (!std::isfinite(log_odds)) return palette::no_evidence;
  const Color full = log_odds > 0.0 ? palette::opposite : palette::belief;
  const double share = std::sqrt(std::min(1.0, std::abs(log_odds) / kFullEvidence));
  const auto mixed = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround((1.0 - share) * from + share * to));
  };
  return {mixed(palette::no_evidence.red, full.red), mixed(palette::no_evidence.green, full.green),
          mixed(palette::no_evidence.blue, full.blue)};
}

Color bin_color(int bin) {
  if (bin <= 0) return {18, 18, 20};
  if (bin == 1) return {255, 255, 255};
  const int slice = (bin - 2) / 4;
  const int quadrant = (bin - 2) % 4;
  constexpr double kLuma[] = {56.0, 128.0, 196.0};
  const double away = slice == 1 ? 52.0 : 42.0;
  const auto chroma = [&](bool high) { return high ? 128.0 + away : 128.0 - away; };
  return to_color(kLuma[std::min(slice, 2)], chroma((quadrant & 1) != 0), chroma((quadrant & 2) != 0));
}

void add_histogram(const HistogramBars& bars, const ChartPlace& place, double full_share, double line_thickness,
                   std::vector<Shape<Eigen::Vector2d>>& shapes) {
  constexpr double kGap = 0.1;  // between two bars, as a fraction of a bin's width
  for (int bin = 0; bin < kHistogramBins; ++bin) {
    const auto add_bar = [&](double end) {
      const double from = (bin + kGap / 2.0) / kHistogramBins, to = (bin + 1.0 - kGap / 2.0) / kHistogramBins;
      shapes.push_back(
          {{place(from, 0.0), place(from, end), place(to, end), place(to, 0.0)}, {}, 0.0, true, bin_color(bin)});
    };
    const auto index = static_cast<std::size_t>(bin);
    const double up = std::min(bars.share[index] / full_share, 1.0);
    const double down = std::min(bars.deviation[index] / (0.25 * full_share), 1.0);
    if (up > 0.0) add_bar(up);  // false for NaN
    if (down > 0.0) add_bar(-down);
  }
  Shape<Eigen::Vector2d> base{.color = palette::faint_ink, .thickness = line_thickness};  // the base may be curved
  for (int bin = 0; bin <= kHistogramBins; ++bin)
    base.points.push_back(place(static_cast<double>(bin) / kHistogramBins, 0.0));
  shapes.push_back(std::move(base));
}

ChartPlace upright_chart(const Eigen::Vector2d& top_left, const Eigen::Vector2d& bottom_right, double below) {
  const Eigen::Vector2d size = bottom_right - top_left;
  const double base = bottom_right.y() - below * size.y();
  return [=](double along, double up) {
    const double reach = up > 0.0 ? base - top_left.y() : below * size.y();
    return Eigen::Vector2d(top_left.x() + along * size.x(), base - up * reach);
  };
}

}  // namespace reorient::scene
