// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/camera_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "workbench/views/pictures/canvas/ycbcr.h"
#include "workbench/views/pictures/parts/legend.h"
#include "workbench/views/pictures/parts/scene_drawing.h"

namespace reorient::pictures {
namespace {

constexpr int kImageWidth = 1280;
constexpr double kLegend = 84.0;
constexpr double kCaption = 28.0;

// Transformation from pixels of the image to the canvas.
struct ImageScale {
  double scale = 1.0;
  double mark = 1.0;  // size of marks, relative to a picture of kImageWidth
  double image_width = kImageWidth;
  Pixel operator()(const Eigen::Vector2d& pixel) const { return (pixel + Pixel(0.5, 0.5)) * scale; }
  Brush brush() const { return {.scale = mark * kImageWidth / image_width, .mark = mark, .shadows = true}; }
};

/// The symbol of a layer, or else its first shape and circle, at most 30 x 18 pixels.
LegendEntry entry_of(const scene::OverlayLayer& layer, Brush brush) {
  scene::OverlayLayer symbol;
  if (!layer.symbol.empty()) {
    symbol.shapes = layer.symbol;
    brush.scale = 1.0;
  } else if (!layer.shapes.empty()) {
    scene::Shape<Pixel> shape = layer.shapes.front();
    shape.points = {{-15.0, 0.0}, {15.0, 0.0}};
    if (shape.closed) shape.points = {{-15.0, -8.0}, {15.0, -8.0}, {15.0, 8.0}, {-15.0, 8.0}};
    symbol.shapes.push_back(std::move(shape));
  }
  if (!layer.circles.empty()) {
    scene::Circle<Pixel> circle = layer.circles.front();
    circle.center.setZero();
    circle.radius = std::clamp(circle.radius, 3.0 / brush.scale, 7.0 / brush.scale);
    symbol.circles.push_back(circle);
  }
  return {[=](Canvas& canvas, const Pixel& center) {
            draw_layer(
                canvas, symbol, [&](const Pixel& point) { return Pixel(center + point); }, brush);
          },
          layer.meaning};
}

void draw_image(Canvas& canvas, const CameraView& camera, const ImageScale& scale, const Box& image) {
  canvas.within(image, [&] {
    canvas.fill_box(image, palette::plate);
    if (!camera.image.empty()) canvas.image(to_picture(camera.image), image);
    for (const scene::OverlayLayer& layer : camera.overlay) draw_layer(canvas, layer, scale, scale.brush());
  });
}

}  // namespace

Picture draw_camera_view(const CameraView& camera, const std::string& caption) {
  const bool seen = !camera.image.empty();
  const double image_width = seen ? camera.image.width : kImageWidth / 2.0;
  const ImageScale scale{kImageWidth / image_width, 1.0, image_width};
  const double height = seen ? std::clamp(camera.image.height * scale.scale, 90.0, 4000.0) : 960.0;
  const double below = kLegend + (caption.empty() ? 0.0 : kCaption);
  Canvas canvas(kImageWidth, static_cast<int>(std::lround(height + below)));
  draw_image(canvas, camera, scale, {0.0, 0.0, kImageWidth, height});
  double beside = 24.0;
  if (caption.empty()) {
    char time[48];
    std::snprintf(time, sizeof time, "%.1f s", camera.time);
    canvas.text({kImageWidth - 16.0, height + 30.0}, time,
                {.size = 19.0, .color = palette::faint_ink, .align = Align::right});
    beside = 130.0;
  } else {
    const TextStyle style{.size = 19.0, .color = palette::faint_ink};
    canvas.text({16.0, height + kLegend + 12.0}, shortened(caption, kImageWidth - 32.0, style), style);
  }
  std::vector<LegendEntry> entries;
  for (const scene::OverlayLayer& layer : camera.overlay)
    if (!layer.empty()) entries.push_back(entry_of(layer, scale.brush()));
  draw_legend_rows(canvas, {12.0, height + 9.0, kImageWidth - beside, kLegend - 12.0}, entries);
  return canvas.finish();
}

Picture draw_camera_thumbnail(const CameraView& camera, int width) {
  constexpr double kLeastMark = 0.35;
  const double image_width = camera.image.empty() ? width : camera.image.width;
  const ImageScale scale{width / image_width, std::max(kLeastMark, 1.0 * width / kImageWidth), image_width};
  const double height = std::clamp(std::round(camera.image.height * scale.scale), 8.0, 4.0 * width);
  Canvas canvas(width, static_cast<int>(height));
  draw_image(canvas, camera, scale, {0.0, 0.0, static_cast<double>(width), height});
  return canvas.finish();
}

}  // namespace reorient::pictures
