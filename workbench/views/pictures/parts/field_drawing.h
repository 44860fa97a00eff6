// SPDX-License-Identifier: MIT
// The field from above, and robots on it.
#pragma once

#include <span>

#include "geometry/field_dimensions.h"
#include "workbench/views/pictures/canvas/canvas.h"
#include "workbench/views/pictures/parts/legend.h"
#include "workbench/views/scene/shapes.h"

namespace reorient::pictures {

/// From meters on the field (x right, y up) to pixels.
struct FieldView {
  Pixel center = Pixel::Zero();  ///< where the field's center is
  double pixels_per_meter = 40.0;

  Pixel operator*(const Eigen::Vector2d& point_in_field) const {
    return center + pixels_per_meter * Pixel(point_in_field.x(), -point_in_field.y());
  }

  /// The field with its border as large as it fits into `box`, centered.
  static FieldView fitted(const FieldDimensions& field, const Box& box);
};

/// The scene of a field, without the names of the goals.
void draw_field(Canvas& canvas, const FieldView& view, const FieldDimensions& field);

/// A robot: a disc with a nose, and the wedge into which it looks (60 degrees). A particle: a dot with a short line in
/// its direction.
void draw_poses(Canvas& canvas, const FieldView& view, std::span<const scene::PoseLayer> layers);

/// One for each layer: its symbol, looking to the right.
std::vector<LegendEntry> pose_entries(std::span<const scene::PoseLayer> layers);

/// "2 m", so that sizes can be read off.
void draw_scale_bar(Canvas& canvas, const FieldView& view, const Pixel& center, Color color);

}  // namespace reorient::pictures
