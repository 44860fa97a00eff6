// SPDX-License-Identifier: MIT
// The field lines as equations: finds the nearest one to a position, and the side on which the position is.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/angle.h"
#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/pinned_math.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"

namespace reorient {

struct NearestFieldLine {
  Eigen::Vector2d normal;                                 ///< unit vector across the line, field frame
  double distance = 0.0;                                  ///< m, of the position; positive on the normal's side
  double next = std::numeric_limits<double>::infinity();  ///< m, to the nearest other line, non-negative
};

/// Straight lines and the center circle. Marks and corner arcs are left out.
class FieldLineMap {
 public:
  explicit FieldLineMap(const FieldDimensions& field);

  /// Considers lines whose direction differs from `direction` (a unit vector of either sign) by at most 25 degrees,
  /// only between their ends. Empty if no line fits.
  std::optional<NearestFieldLine> nearest(const Eigen::Vector2d& place, const Eigen::Vector2d& direction) const;

  /// Length of the straight lines, m, that a camera of a robot at `robot` (field frame) has in view, if nothing hides
  /// them, up to `farthest` m from the robot.
  double length_in_view(const Pose2& robot, const CameraModel& camera, const Isometry3& robot_from_camera,
                        double farthest) const;

 private:
  static constexpr double kMostBetween = from_degrees(25.0);

  struct Line {
    Eigen::Vector2d from;
    Eigen::Vector2d along;  // unit vector
    double length = 0.0;
  };
  std::vector<Line> lines_;
  double circle_;
  double least_cosine_ = pinned::cos(kMostBetween), most_sine_ = pinned::sin(kMostBetween);
};

}  // namespace reorient
