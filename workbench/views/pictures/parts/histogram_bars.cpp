#include "workbench/views/pictures/parts/histogram_bars.h"

#include <algorithm>
#include <cmath>

#include "workbench/views/pictures/canvas/ycbcr.h"

namespace reorient::pictures {
namespace {

constexpr double kGap = 0.1;  // of a bin's width, between two bars

void draw_bar(Canvas& canvas, const ChartPlace& place, int bin, double end, Color color) {
  const double from = (bin + kGap / 2.0) / kHistogramBins;
  const double to = (bin + 1.0 - kGap / 2.0) / kHistogramBins;
  const Pixel outline[] = {place(from, 0.0), place(from, end), place(to, end), place(to, 0.0)};
  canvas.fill(outline, color);
}

}  // namespace

Color bin_color(int bin) {
  if (bin <= 0) return {18, 18, 20};
  if (bin == 1) return {255, 255, 255};
  const int slice = (bin - 2) / 4;
  const int quadrant = (bin - 2) % 4;
  const std::uint8_t luma[] = {56, 128, 196};
  const int away = slice == 1 ? 52 : 42;
  const auto chroma = [&](bool high) { return static_cast<std::uint8_t>(high ? 128 + away : 128 - away); };
  return to_color({luma[std::min(slice, 2)], chroma((quadrant & 1) != 0), chroma((quadrant & 2) != 0)});
}

void draw_histogram(Canvas& canvas, const HistogramBars& bars, const ChartPlace& place, double full_share) {
  for (int bin = 0; bin < kHistogramBins; ++bin) {
    const auto index = static_cast<std::size_t>(bin);
    const double up = std::min(bars.share[index] / full_share, 1.0);
    const double down = std::min(bars.deviation[index] / (0.25 * full_share), 1.0);
    if (up > 0.0) draw_bar(canvas, place, bin, up, bin_color(bin));  // false for NaN
    if (down > 0.0) draw_bar(canvas, place, bin, -down, bin_color(bin));
  }
  std::array<Pixel, kHistogramBins + 1> base;  // it may be bent
  for (std::size_t i = 0; i < base.size(); ++i) base[i] = place(static_cast<double>(i) / kHistogramBins, 0.0);
  canvas.polyline(base, palette::faint_ink, 0.5);
}

void draw_histogram(Canvas& canvas, const HistogramBars& bars, const Box& box, double below, double full_share) {
  const double base = box.bottom() - below * box.height;
  const auto place = [&](double along, double up) {
    const double reach = up > 0.0 ? base - box.top : below * box.height;
    return Pixel(box.left + along * box.width, base - up * reach);
  };
  draw_histogram(canvas, bars, place, full_share);
}

void draw_bin_legend(Canvas& canvas, const Pixel& top_left) {
  constexpr double kSquare = 26.0;
  const TextStyle small{.size = 16.0, .color = palette::faint_ink, .align = Align::center};
  const char* names[] = {"dark", "medium", "bright"};
  const auto square = [&](double x, double y, int bin) {
    const Box box{top_left.x() + x, top_left.y() + y, kSquare, kSquare};
    canvas.fill_box(box, palette::faint_ink);
    canvas.fill_box({box.left + 1.0, box.top + 1.0, kSquare - 2.0, kSquare - 2.0}, bin_color(bin));
  };
  square(0.0, 0.0, 1);
  square(0.0, kSquare, 0);
  for (int slice = 0; slice < 3; ++slice) {
    const double left = 54.0 + slice * 76.0;
    for (int quadrant = 0; quadrant < 4; ++quadrant)  // Cb grows to the right, Cr upwards
      square(left + (quadrant & 1) * kSquare, (1 - (quadrant >> 1)) * kSquare, 2 + 4 * slice + quadrant);
    canvas.text(top_left + Pixel(left + kSquare, 2.0 * kSquare + 20.0), names[slice], small);
  }
  canvas.text(top_left + Pixel(kSquare / 2.0, 2.0 * kSquare + 20.0), "gray", small);
  TextStyle axes = small;
  axes.align = Align::left;
  canvas.text(top_left + Pixel(0.0, 2.0 * kSquare + 44.0), "squares: Cb right, Cr up", axes);
}

}  // namespace reorient::pictures
