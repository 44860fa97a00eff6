// SPDX-License-Identifier: MIT
// The ball: something round and as large as a ball at its distance, with carpet around.
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

  /// The one that looks most like a ball. Reads the percept's boundary. `lines`: those that may pass behind the
  /// ball.
  std::optional<Ball> find(const FieldImage& seen, const CarpetMap& map, const KnownLines& lines,
                           const FieldPercept& percept) const;

 private:
  /// What find() works on.
  struct Frame : FieldImage {
    const KnownLines& lines;
  };
  /// Where a ball may be in the image, and how much it looks like one.
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
