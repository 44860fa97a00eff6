// SPDX-License-Identifier: MIT
// The field from above, and robots on it.
#pragma once

#include <span>

#include "geometry/field_dimensions.h"
#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/pictures/parts/legend.h"
#include "workbench/views/scene/shapes.h"

namespace reorient::pictures {

/// Conversion from meters on the field (x right, y up) to pixels.
struct FieldView {
  Pixel center = Pixel::Zero();  ///< the field's center
  double pixels_per_meter = 40.0;

  Pixel operator*(const Eigen::Vector2d& point_in_field) const {
    return center + pixels_per_meter * Pixel(point_in_field.x(), -point_in_field.y());
  }

  /// Fits the field with its border into `box`, centered.
  static FieldView fitted(const FieldDimensions& field, const Box& box);
};

/// The scene of a field, without the names of the goals.
void draw_field(Canvas& canvas, const FieldView& view, const FieldDimensions& field);

/// Draws a robot as a disc with a nose and a wedge of 60 degrees in its viewing direction, and a particle as a dot with
/// a short line in its direction.
void draw_poses(Canvas& canvas, const FieldView& view, std::span<const scene::PoseLayer> layers);

/// One entry for each layer: its symbol, directed to the right.
std::vector<LegendEntry> pose_entries(std::span<const scene::PoseLayer> layers);

/// A scale bar "2 m".
void draw_scale_bar(Canvas& canvas, const FieldView& view, const Pixel& center, Color color);

}  // namespace reorient::pictures
