// SPDX-License-Identifier: MIT
// Finds straight edges in an image that are nearly vertical in the room: line segments as connected regions of pixels
// with about the same direction of the gradient (von Gioi et al., LSD: a line segment detector, 2012).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/angle.h"
#include "geometry/camera.h"
#include "geometry/image.h"
#include "geometry/transform.h"

namespace reorient {

/// Largest angle between a nearly vertical edge and the projected vertical, rad.
inline constexpr double kNearlyVertical = from_degrees(15.0);

struct ImageEdge {
  Eigen::Vector2d upper = Eigen::Vector2d::Zero();  ///< pixel
  Eigen::Vector2d lower = Eigen::Vector2d::Zero();
  double length() const { return (lower - upper).norm(); }  ///< pixels
};

/// Edges within `reach` (rad) of the projected vertical.
std::vector<ImageEdge> vertical_edges(const ImageView& image, const CameraModel& camera,
                                      const Isometry3& robot_from_camera, double reach);

}  // namespace reorient
