// The field from above, and robots on it.
#pragma once

#include <span>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "workbench/views/pictures/canvas/canvas.h"

namespace reorient::pictures {

/// From metres on the field (x right, y up) to pixels.
struct FieldView {
  Pixel center = Pixel::Zero();  ///< where the field's centre is
  double pixels_per_metre = 40.0;

  Pixel operator*(const Eigen::Vector2d& point_in_field) const {
    return center + pixels_per_metre * Pixel(point_in_field.x(), -point_in_field.y());
  }

  /// The field with its border as large as it fits into `box`, centred.
  static FieldView fitted(const FieldDimensions& field, const Box& box);
};

/// Carpet, lines, and goals with their nets.
void draw_field(Canvas& canvas, const FieldView& view, const FieldDimensions& field);

/// Pixels. The truth is larger than the belief, so that it shows below a belief that is right.
inline constexpr double kBeliefRadius = 8.0;
inline constexpr double kTruthRadius = 12.0;

/// A robot as a disc with a nose, and the wedge into which it looks (60 degrees). Sized for people, not to scale.
void draw_robot(Canvas& canvas, const FieldView& view, const Pose2& pose, Color color, double radius = kBeliefRadius);

/// The same symbol for a legend, looking to the right.
void draw_robot_symbol(Canvas& canvas, const Pixel& center, Color color);

/// Each particle a dot with a short line in its direction.
void draw_pose_particles(Canvas& canvas, const FieldView& view, std::span<const Pose2> particles);

/// "2 m", so that sizes can be read off.
void draw_scale_bar(Canvas& canvas, const FieldView& view, const Pixel& center, Color color);

}  // namespace reorient::pictures
