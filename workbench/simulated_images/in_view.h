// SPDX-License-Identifier: MIT
// The field features in view of the simulated camera, by the simulator's own labels: the reference for the field
// vision.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_landmarks.h"
#include "geometry/pose2.h"
#include "robots/robot.h"
#include "robots/simulator/simulator.h"

namespace reorient {

/// Position in the robot frame, m; `clearly`: whether enough of it is in view to count.
struct Thing {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  bool clearly = false;
};

struct IntersectionInView : Thing {
  IntersectionKind kind = IntersectionKind::l;
  double direction = 0.0;  ///< rad, robot frame
};

/// All objects and features of the field, also those out of view, so that percepts at the image's edge are not false.
struct FieldInView {
  std::vector<Thing> line_places;  ///< 0.1 m apart, only those in view
  std::vector<Thing> goal_posts;   ///< foot and half a meter above it are clear
  std::vector<Thing> robots;       ///< the side toward the camera; clear at the feet, without another robot before them
  std::vector<IntersectionInView> intersections;  ///< clear along 0.3 m of each arm
  std::vector<Thing> corner_arcs;      ///< the corner; clear along 0.3 m of its lines and in the middle half of the arc
  std::vector<Thing> penalty_marks;    ///< clear with some carpet all around
  std::optional<Thing> center_circle;  ///< a third of its line is clear
  std::optional<Thing> ball;           ///< the whole of it is clear
  int bottom_row = 0;                  ///< of the image
  Pose2 robot;                         ///< field frame, where the image was taken
};

/// `frame`: the upper camera's latest image, which the simulator must have labels of.
FieldInView field_in_view(const Simulator& simulator, const CameraFrame& frame, const FieldDimensions& field);

/// Distance from the middle of the nearest line, circles and arcs included (m); `normal`: rad, of that line, field
/// frame.
struct LineNearby {
  double distance = 0.0;
  double normal = 0.0;
};
LineNearby nearest_line_of(const FieldDimensions& field, const Eigen::Vector2d& place);

}  // namespace reorient
