// SPDX-License-Identifier: MIT
// The center circle, from line points on it, and the halfway line through its center.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/ground_projection.h"
#include "perception/field/percepts.h"

namespace reorient {

class CenterCircleFinder {
 public:
  CenterCircleFinder(const FieldFeatureParameters& parameters, const FieldDimensions& field);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// The circle of the field's radius with the most votes of points. An arc of about 75 degrees is enough.
  std::optional<CenterCircle> find(std::span<const LinePoint> points, const GroundProjection& view);

 private:
  std::optional<Eigen::Vector2d> vote(std::span<const LinePoint> points);
  void find_halfway_line(std::span<const LinePoint> points, CenterCircle& circle) const;

  FieldFeatureParameters parameters_;
  double radius_ = 0.0;
  std::vector<Eigen::Vector2d> votes_;
};

}  // namespace reorient
