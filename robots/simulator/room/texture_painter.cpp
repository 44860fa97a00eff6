// SPDX-License-Identifier: MIT
#include "robots/simulator/room/texture_painter.h"

#include <cmath>
#include <vector>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

double overlap(double low, double high, double from, double to) {
  return std::max(0.0, std::min(high, to) - std::max(low, from));
}

}  // namespace

TexturePainter::TexturePainter(double width, double height, double per_meter, const LinearColor& color)
    : width_(width), height_(height), image_(texels_for(width, per_meter), texels_for(height, per_meter), color) {}

template <typename Paint>
void TexturePainter::for_each(const Area& area, Paint&& paint) {
  const double scale_x = image_.width / width_;
  const double scale_y = image_.height / height_;
  const double left = area.left * scale_x;
  const double right = area.right * scale_x;
  const double bottom = area.bottom * scale_y;
  const double top = area.top * scale_y;
  const int first_column = std::max(0, static_cast<int>(std::floor(left)));
  const int last_column = std::min(image_.width - 1, static_cast<int>(std::ceil(right)) - 1);
  const int first_row = std::max(0, static_cast<int>(std::floor(bottom)));
  const int last_row = std::min(image_.height - 1, static_cast<int>(std::ceil(top)) - 1);
  for (int j = first_row; j <= last_row; ++j) {
    const double height = overlap(j, j + 1, bottom, top);
    for (int i = first_column; i <= last_column; ++i) {
      const double coverage = height * overlap(i, i + 1, left, right);
      paint(image_.at(i, j), coverage, (i + 0.5) / scale_x, (j + 0.5) / scale_y);
    }
  }
}

void TexturePainter::rectangle(const Area& area, const LinearColor& color, double opacity) {
  for_each(area, [&](LinearColor& texel, double coverage, double, double) {
    texel += static_cast<float>(opacity * coverage) * (color - texel);
  });
}

void TexturePainter::ellipse(double x, double y, double radius_x, double radius_y, const LinearColor& color,
                             double opacity) {
  const double softness = width_ / image_.width / std::min(radius_x, radius_y);
  for_each({x - radius_x, y - radius_y, x + radius_x, y + radius_y},
           [&](LinearColor& texel, double, double at_x, double at_y) {
             const double radius = pinned::hypot((at_x - x) / radius_x, (at_y - y) / radius_y);
             const double coverage = std::clamp((1.0 - radius) / softness + 0.5, 0.0, 1.0);
             texel += static_cast<float>(opacity * coverage) * (color - texel);
           });
}

void TexturePainter::shade(const Area& area, double below, double above) {
  for_each(area, [&](LinearColor& texel, double coverage, double, double y) {
    const double factor = std::lerp(below, above, std::clamp((y - area.bottom) / area.height(), 0.0, 1.0));
    texel *= static_cast<float>(1.0 + coverage * (factor - 1.0));
  });
}

void TexturePainter::mottle(const Area& area, double strength, double size, Random& random) {
  const int columns = static_cast<int>(std::ceil(area.width() / size)) + 2;
  const int rows = static_cast<int>(std::ceil(area.height() / size)) + 2;
  std::vector<double> knots(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (double& knot : knots) knot = random.uniform(-1.7, 1.7) * strength;
  const auto knot = [&](int i, int j) {
    return knots[static_cast<std::size_t>(std::clamp(j, 0, rows - 1)) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(std::clamp(i, 0, columns - 1))];
  };
  for_each(area, [&](LinearColor& texel, double coverage, double x, double y) {
    const double u = std::max(0.0, (x - area.left) / size);
    const double v = std::max(0.0, (y - area.bottom) / size);
    const int i = static_cast<int>(u);
    const int j = static_cast<int>(v);
    const double noise = std::lerp(std::lerp(knot(i, j), knot(i + 1, j), u - i),
                                   std::lerp(knot(i, j + 1), knot(i + 1, j + 1), u - i), v - j);
    texel *= static_cast<float>(std::max(0.0, 1.0 + coverage * noise));
  });
}

LinearColor paint_of(double hue, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double turned = hue + offset - std::floor(hue + offset);
    const double full = std::clamp(std::abs(6.0 * turned - 3.0) - 1.0, 0.0, 1.0);
    const double shown = value * std::lerp(1.0, full, saturation);
    return static_cast<float>(shown * shown);  // a gamma of 2, like the simulated camera
  };
  return {channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)};
}

LinearColor any_paint(double hue, const Range& saturation, const Range& value, Random& random) {
  const double drawn_value = random.uniform(value.low, value.high);
  const double drawn_saturation = random.uniform(saturation.low, saturation.high);
  return paint_of(hue, drawn_saturation, drawn_value);
}

LinearColor any_paint(const Range& hue, const Range& saturation, const Range& value, Random& random) {
  const double drawn_value = random.uniform(value.low, value.high);
  const double drawn_saturation = random.uniform(saturation.low, saturation.high);
  return paint_of(random.uniform(hue.low, hue.high), drawn_saturation, drawn_value);
}

}  // namespace reorient
