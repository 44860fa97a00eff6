// SPDX-License-Identifier: MIT
// A small renderer for tests: the flat field with its lines and upright posts, seen by a camera without noise or blur.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/image.h"
#include "geometry/pose2.h"

namespace reorient {

struct Colors {
  Ycbcr carpet{75, 105, 108};
  Ycbcr line{190, 126, 130};
  Ycbcr wall{95, 132, 134};
  Ycbcr post{200, 126, 130};
};

/// An upright object on the field with a square footprint.
struct Box {
  Eigen::Vector2d position;
  double width = 0.1;
  double height = 0.8;
  Ycbcr color;
};

/// A ball that touches the ground.
struct Sphere {
  Eigen::Vector2d position;
  double radius = 0.05;
  Ycbcr color{215, 126, 130};
};

struct FlatField {
  FieldDimensions field;
  Colors colors;
  bool lines = true;
  bool marks = false;  ///< penalty marks, crosses
  std::vector<Box> boxes;
  std::vector<Sphere> spheres;

  static FlatField with_goals();
};

/// Distance from a point in the field frame to the middle of the nearest line (m), and that line's normal there.
struct NearestLine {
  double distance = 1e9;
  double normal = 0.0;
};
NearestLine nearest_line(const FieldDimensions& field, const Eigen::Vector2d& point);

/// Each pixel is the mean of four rays.
Image render(const FlatField& scene, const CameraModel& camera, const Isometry3& field_from_camera);

}  // namespace reorient
