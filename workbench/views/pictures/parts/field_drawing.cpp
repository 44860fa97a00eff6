// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/parts/field_drawing.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "workbench/views/pictures/parts/scene_drawing.h"
#include "workbench/views/scene/field_scene.h"

namespace reorient::pictures {
namespace {

void draw_robot(Canvas& canvas, const Pixel& center, double heading, double radius, double wedge, Color color) {
  if (wedge > 0.0) {
    std::vector<Pixel> sector = arc(center, wedge, heading - kPi / 6.0, heading + kPi / 6.0);
    if (sector.empty()) return;
    sector.push_back(center);
    canvas.fill(sector, color.with_opacity(0.38));
    canvas.polyline(sector, color.with_opacity(0.8), 1.0, true);
  }
  const Pixel forward(std::cos(heading), -std::sin(heading));
  const Pixel left(forward.y(), -forward.x());
  const auto draw_body = [&](double size, Color body) {
    const Pixel nose[] = {center + 1.85 * size * forward, center + 0.9 * size * left + 0.42 * size * forward,
                          center - 0.9 * size * left + 0.42 * size * forward};
    canvas.fill(nose, body);
    canvas.disc(center, size, body);
  };
  draw_body(radius + 2.0, Color{255, 255, 255});
  draw_body(radius, color);
  canvas.disc(center, 2.6, Color{255, 255, 255});
}

void draw_particle(Canvas& canvas, const Pixel& center, double heading, double radius, Color color) {
  canvas.line(center, center + 10.0 * Pixel(std::cos(heading), -std::sin(heading)), color, 1.5);
  canvas.disc(center, radius, color);
}

}  // namespace

FieldView FieldView::fitted(const FieldDimensions& field, const Box& box) {
  const Eigen::Vector2d carpet = 2.0 * carpet_half_size(field);
  const double scale = std::min(box.width / carpet.x(), box.height / carpet.y());
  return {box.center(), std::isfinite(scale) && scale > 0.0 ? scale : 1.0};
}

void draw_field(Canvas& canvas, const FieldView& view, const FieldDimensions& field) {
  const Brush brush{.scale = view.pixels_per_meter, .least_line = 1.5, .least_radius = 2.5};
  for (scene::SceneLayer& layer : scene::field_scene(field)) {
    layer.labels.clear();  // there is no space for them
    draw_layer(
        canvas, layer, [&](const Eigen::Vector3d& point) { return view * point.head<2>(); }, brush);
  }
}

void draw_poses(Canvas& canvas, const FieldView& view, std::span<const scene::PoseLayer> layers) {
  const double wedge = std::clamp(1.1 * view.pixels_per_meter, 34.0, 80.0);
  for (const scene::PoseLayer& layer : layers) {
    for (const Pose2& pose : layer.poses) {
      const Pixel center = view * pose.position;
      if (!center.allFinite()) continue;
      if (layer.is_robot) {
        draw_robot(canvas, center, pose.rotation, layer.radius, wedge, layer.color);
      } else {
        draw_particle(canvas, center, pose.rotation, layer.radius, layer.color);
      }
    }
  }
}

std::vector<LegendEntry> pose_entries(std::span<const scene::PoseLayer> layers) {
  std::vector<LegendEntry> entries;
  for (const scene::PoseLayer& layer : layers) {
    const auto symbol = [is_robot = layer.is_robot, radius = layer.radius, color = layer.color](Canvas& canvas,
                                                                                                const Pixel& center) {
      if (is_robot) {
        draw_robot(canvas, center - Pixel(3.0, 0.0), 0.0, std::min(radius, 8.0), 0.0, color);
      } else {
        draw_particle(canvas, center - Pixel(4.0, 0.0), 0.0, radius, color);
      }
    };
    entries.push_back({symbol, layer.meaning});
  }
  return entries;
}

void draw_scale_bar(Canvas& canvas, const FieldView& view, const Pixel& center, Color color) {
  const Pixel half(view.pixels_per_meter, 0.0);
  const Pixel tick(0.0, 5.0);
  canvas.line(center - half, center + half, color, 1.5);
  for (const Pixel& end : {Pixel(center - half), Pixel(center + half)}) canvas.line(end - tick, end + tick, color, 1.5);
  canvas.text(center - Pixel(0.0, 8.0), "2 m",
              {.size = 17.0, .color = color, .align = Align::center, .halo = palette::page});
}

}  // namespace reorient::pictures
