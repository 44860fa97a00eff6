// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/parts/histogram_bars.h"

#include "workbench/views/pictures/parts/scene_drawing.h"

namespace reorient::pictures {

void draw_histogram(Canvas& canvas, const scene::HistogramBars& bars, const scene::ChartPlace& place,
                    double full_share) {
  scene::OverlayLayer layer;
  add_histogram(bars, place, full_share, 0.5, layer.shapes);
  draw_layer(canvas, layer, [](const Pixel& pixel) { return pixel; }, {});
}

void draw_bin_legend(Canvas& canvas, const Pixel& top_left) {
  constexpr double kSquare = 26.0;
  const TextStyle small{.size = 16.0, .color = palette::faint_ink, .align = Align::center};
  const char* names[] = {"dark", "medium", "bright"};
  const auto square = [&](double x, double y, int bin) {
    const Box box{top_left.x() + x, top_left.y() + y, kSquare, kSquare};
    canvas.fill_box(box, palette::faint_ink);
    canvas.fill_box({box.left + 1.0, box.top + 1.0, kSquare - 2.0, kSquare - 2.0}, scene::bin_color(bin));
  };
  square(0.0, 0.0, 1);
  square(0.0, kSquare, 0);
  for (int slice = 0; slice < 3; ++slice) {
    const double left = 54.0 + slice * 76.0;
    for (int quadrant = 0; quadrant < 4; ++quadrant)  // Cb grows to the right, Cr upward
      square(left + (quadrant & 1) * kSquare, (1 - (quadrant >> 1)) * kSquare, 2 + 4 * slice + quadrant);
    canvas.text(top_left + Pixel(left + kSquare, 2.0 * kSquare + 20.0), names[slice], small);
  }
  canvas.text(top_left + Pixel(kSquare / 2.0, 2.0 * kSquare + 20.0), "gray", small);
  TextStyle axes = small;
  axes.align = Align::left;
  canvas.text(top_left + Pixel(0.0, 2.0 * kSquare + 44.0), "squares: Cb right, Cr up", axes);
}

}  // namespace reorient::pictures
