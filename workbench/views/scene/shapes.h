// SPDX-License-Identifier: MIT
// The contents of a view as plain values. A scene is in meters, x right, y up as seen from above, z toward the viewer.
// An overlay is in pixels of a camera's image, u right, v down, (0, 0) the center of the top left pixel.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose2.h"
#include "workbench/views/scene/color.h"

namespace reorient::scene {

/// A line through points, or a convex polygon. Lengths are in the unit of the points.
template <typename Point>
struct Shape {
  std::vector<Point> points = {};
  Color color = {};        ///< color of the line
  double thickness = 0.0;  ///< thickness of the line; 0: no line
  bool closed = false;
  Color fill = {0, 0, 0, 0.0};
  bool dashed = false;  ///< ignored by views that cannot draw dashes
};

template <typename Point>
struct Circle {
  Point center = Point::Zero();
  double radius = 0.0;
  Color color = {};
  double ring = 0.0;    ///< thickness of the ring; 0: the circle is filled
  double height = 0.0;  ///< height of the cylinder above the circle, in a scene
};

/// A text to the right of a position.
template <typename Point>
struct Label {
  Point position = Point::Zero();
  std::string text = {};
  double size = 0.0;
  Color color = {};
};

/// Objects of the same meaning. They are drawn in the order shapes, circles, labels.
template <typename Point>
struct Layer {
  std::string meaning = {};  ///< text of the legend
  std::vector<Shape<Point>> shapes = {};
  std::vector<Circle<Point>> circles = {};
  std::vector<Label<Point>> labels = {};
  /// Symbol of the legend, within 30 by 18 units around the origin; empty: the first shape and circle of the layer.
  std::vector<Shape<Point>> symbol = {};

  bool empty() const { return shapes.empty() && circles.empty() && labels.empty(); }
};

using SceneLayer = Layer<Eigen::Vector3d>;
using OverlayLayer = Layer<Eigen::Vector2d>;

/// Layers in the order of drawing.
using Scene = std::vector<SceneLayer>;
using Overlay = std::vector<OverlayLayer>;

/// Poses of the same meaning, drawn as symbols that are not to scale.
struct PoseLayer {
  std::string meaning;
  std::vector<Pose2> poses;
  Color color;
  double radius = 0.0;    ///< radius of the symbol, pixels
  bool is_robot = false;  ///< true: a robot with its viewing direction; false: a particle
};

}  // namespace reorient::scene
