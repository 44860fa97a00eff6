// SPDX-License-Identifier: MIT
// Positions and types of intersections of lines. The image shows which of the four arms exist.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/field_image.h"
#include "perception/field/lines/line_segments.h"
#include "perception/field/percepts.h"

namespace reorient {

class Intersections {
 public:
  Intersections(const FieldFeatureParameters& parameters, const FieldDimensions& field);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Sets the percept's intersections: those of straight pieces of line that meet at about a right angle, those where a
  /// straight piece ends at a line that was hardly found, and those of the percept's center circle with the halfway
  /// line.
  void find(const FieldImage& seen, std::span<const LineSegment> segments, FieldPercept& percept) const;

 private:
  enum class Stripe { there, not_there, hidden };
  /// Input of find().
  struct Frame : FieldImage {
    const FieldPercept& percept;
  };

  Stripe stripe_at(const Frame& frame, const Eigen::Vector2d& place, const Eigen::Vector2d& across) const;
  Stripe arm_at(const Frame& frame, const Eigen::Vector2d& corner, const Eigen::Vector2d& along) const;
  bool has_corner_arc(const Frame& frame, const Eigen::Vector2d& corner, double direction) const;
  std::optional<Intersection> meet(const Frame& frame, const LineSegment& a, const LineSegment& b) const;
  std::optional<Intersection> at_end(const Frame& frame, const Eigen::Vector2d& end, const Eigen::Vector2d& out) const;
  void add(const std::optional<Intersection>& found, FieldPercept& percept) const;
  void add_circle(const Frame& frame, FieldPercept& percept) const;
  Intersection at(const Frame& frame, const Eigen::Vector2d& position, IntersectionKind kind, double direction) const;

  FieldFeatureParameters parameters_;
  FieldDimensions field_;
};

}  // namespace reorient
