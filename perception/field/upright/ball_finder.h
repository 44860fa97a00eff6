// SPDX-License-Identifier: MIT
// The ball: a round object with the size of a ball at its distance, and carpet around it.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "perception/field/carpet/carpet_map.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/field_image.h"
#include "perception/field/lines/known_lines.h"
#include "perception/field/percepts.h"

namespace reorient {

class BallFinder {
 public:
  BallFinder(const FieldFeatureParameters& parameters, const FieldDimensions& field);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// The object most similar to a ball. Reads the percept's boundary, obstacles, posts and line points. `lines`: those
  /// that may pass behind the ball.
  std::optional<Ball> find(const FieldImage& seen, const CarpetMap& map, const KnownLines& lines,
                           const FieldPercept& percept) const;

 private:
  /// Input of find().
  struct Frame : FieldImage {
    const KnownLines& lines;
  };
  /// A possible ball in the image, and its similarity to a ball.
  struct Circle {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< pixels
    double radius = 0.0;
    double likeness = 0.0;  ///< 0 to 1
  };
  std::optional<Circle> circle_above(const GroundProjection& view, double column, double foot) const;
  std::optional<Circle> circle_around(const GroundProjection& view, const Eigen::Vector2d& center) const;
  double likeness(const Frame& frame, const Circle& circle) const;

  FieldFeatureParameters parameters_;
  double radius_ = 0.0;  ///< m
};

}  // namespace reorient
