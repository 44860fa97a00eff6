// SPDX-License-Identifier: MIT
// The field features of one image: border, lines, marks, goal posts, obstacles and the ball.
#pragma once

#include <Eigen/Geometry>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/image.h"
#include "geometry/transform.h"
#include "perception/field/carpet/boundary.h"
#include "perception/field/carpet/carpet_color.h"
#include "perception/field/carpet/carpet_map.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/landmarks/center_circle.h"
#include "perception/field/landmarks/intersections.h"
#include "perception/field/landmarks/penalty_marks.h"
#include "perception/field/lines/known_lines.h"
#include "perception/field/lines/line_points.h"
#include "perception/field/lines/line_segments.h"
#include "perception/field/percepts.h"
#include "perception/field/upright/ball_finder.h"
#include "perception/field/upright/goal_posts.h"
#include "perception/field/upright/obstacles.h"

namespace reorient {

/// Uses the image alone, without pose or time. Only the carpet's color persists from image to image.
class FieldFeatures {
 public:
  FieldFeatures(const FieldFeatureParameters& parameters, const FieldDimensions& field);

  /// Writes into `percept` and reuses its memory. The result is empty, with a boundary at the image's bottom, if
  /// nothing can be seen: no carpet is known yet, the image is empty, or the camera lies on the ground, hangs upside
  /// down or has no finite position.
  void find(const ImageView& image, const CameraModel& camera, const Isometry3& robot_from_camera,
            FieldPercept& percept);

  /// Takes effect with the next image.
  void set_parameters(const FieldFeatureParameters& parameters);

  const CarpetColor& carpet_color() const { return carpet_color_; }

  /// The learned values. Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.carpet_color_);
  }

 private:
  CarpetColor carpet_color_;
  CarpetMap carpet_map_;
  Boundary boundary_;
  GoalPosts goal_posts_;
  Obstacles obstacles_;
  LinePoints line_points_;
  LineSegments line_segments_;
  CenterCircleFinder center_circle_;
  Intersections intersections_;
  PenaltyMarks penalty_marks_;
  BallFinder ball_;
  double circle_radius_;  ///< m
  double line_width_;     ///< m
};

}  // namespace reorient
