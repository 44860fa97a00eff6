// SPDX-License-Identifier: MIT
// Draws layers of scenes and overlays on a canvas.
#pragma once

#include <algorithm>
#include <vector>

#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/scene/shapes.h"

namespace reorient::pictures {

struct Brush {
  double scale = 1.0;         ///< pixels of the canvas for each unit of thicknesses and radii
  double mark = 1.0;          ///< pixels of the canvas; approximate width of rims and shadows
  double least_line = 0.0;    ///< pixels
  double least_radius = 0.0;  ///< pixels, of filled circles
  bool shadows = false;       ///< below lines, so that a light line is visible on a light background
};

/// `place` returns the canvas's pixel of a point. Labels are upright, to the right of their position.
template <typename Point, typename Place>
void draw_layer(Canvas& canvas, const scene::Layer<Point>& layer, const Place& place, const Brush& brush) {
  const Color shadow{0, 0, 0, 0.35};
  for (const scene::Shape<Point>& shape : layer.shapes) {
    std::vector<Pixel> points;
    points.reserve(shape.points.size());
    for (const Point& point : shape.points) points.push_back(place(point));
    canvas.fill(points, shape.fill);
    if (!(shape.thickness > 0.0)) continue;
    const double thickness = std::max(brush.least_line, shape.thickness * brush.scale);
    if (shape.dashed) {
      for (std::size_t i = shape.closed ? 0 : 1; i < points.size(); ++i)
        canvas.dashed_line(points[i == 0 ? points.size() - 1 : i - 1], points[i], shape.color, thickness,
                           6.0 * brush.mark);
      continue;
    }
    if (brush.shadows && thickness > brush.mark)
      canvas.polyline(points, shadow, thickness + 2.0 * brush.mark, shape.closed);
    canvas.polyline(points, shape.color, thickness, shape.closed);
  }
  for (const scene::Circle<Point>& circle : layer.circles) {
    const Pixel center = place(circle.center);
    if (circle.ring > 0.0) {
      canvas.ring(center, circle.radius * brush.scale, shadow, circle.ring * brush.scale + 2.0 * brush.mark);
      canvas.ring(center, circle.radius * brush.scale, circle.color, circle.ring * brush.scale);
    } else {
      const double radius = std::max(brush.least_radius, circle.radius * brush.scale);
      canvas.disc(center, radius + 1.2 * brush.mark, palette::ink.with_opacity(0.6));
      canvas.disc(center, radius, circle.color);
    }
  }
  for (const scene::Label<Point>& label : layer.labels) {
    const double size = label.size * brush.scale;
    canvas.text(place(label.position) + Pixel(0.25 * size, 0.3 * size), label.text,
                {.size = size, .color = label.color, .bold = true, .halo = palette::ink});
  }
}

}  // namespace reorient::pictures
