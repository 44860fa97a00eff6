// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/parts/legend.h"

#include <utility>

namespace reorient::pictures {
namespace {

constexpr double kSymbolWidth = 40.0;
constexpr double kLineHeight = 1.55;  // times the size of the text

void draw_entry(Canvas& canvas, const Pixel& left_center, const LegendEntry& entry, double size) {
  if (entry.symbol) entry.symbol(canvas, left_center + Pixel(kSymbolWidth / 2.0 - 2.0, 0.0));
  canvas.text(left_center + Pixel(kSymbolWidth + 4.0, 0.35 * size), entry.meaning, {.size = size});
}

}  // namespace

double draw_legend_column(Canvas& canvas, const Pixel& top_left, std::span<const LegendEntry> entries, double size) {
  double y = top_left.y();
  for (const LegendEntry& entry : entries) {
    draw_entry(canvas, {top_left.x(), y + size * kLineHeight / 2.0}, entry, size);
    y += size * kLineHeight;
  }
  return y;
}

void draw_legend_rows(Canvas& canvas, const Box& box, std::span<const LegendEntry> entries, double size) {
  const double height = size * kLineHeight;
  double x = box.left;
  double y = box.top + height / 2.0;
  for (const LegendEntry& entry : entries) {
    const double width = kSymbolWidth + 4.0 + Canvas::text_width(entry.meaning, {.size = size});
    if (x > box.left && x + width > box.right()) {
      x = box.left;
      y += height;
    }
    if (y + height / 2.0 > box.bottom() + 0.5) return;
    draw_entry(canvas, {x, y}, entry, size);
    x += width + 26.0;
  }
}

std::string short_name(Reorientation reorientation) {
  const std::string name(to_string(reorientation));
  return name.substr(0, name.find('_'));
}

LegendEntry line_entry(Color color, double thickness, std::string meaning) {
  const auto symbol = [=](Canvas& canvas, const Pixel& center) {
    canvas.line(center - Pixel(16.0, 0.0), center + Pixel(16.0, 0.0), color, thickness);
  };
  return {symbol, std::move(meaning)};
}

LegendEntry patch_entry(Color color, std::string meaning) {
  const auto symbol = [=](Canvas& canvas, const Pixel& center) {
    canvas.fill_box({center.x() - 15.0, center.y() - 8.0, 30.0, 16.0}, color);
  };
  return {symbol, std::move(meaning)};
}

LegendEntry dot_entry(Color color, double radius, std::string meaning) {
  const auto symbol = [=](Canvas& canvas, const Pixel& center) { canvas.disc(center, radius, color); };
  return {symbol, std::move(meaning)};
}

}  // namespace reorient::pictures
