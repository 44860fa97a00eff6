// SPDX-License-Identifier: MIT
// Penalty marks: white spots with the size of a mark and carpet all around.
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "perception/field/field_feature_parameters.h"
#include "perception/field/field_image.h"
#include "perception/field/percepts.h"

namespace reorient {

class PenaltyMarks {
 public:
  PenaltyMarks(const FieldFeatureParameters& parameters, const FieldDimensions& field);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Reads the percept's ball and sets its marks. `lone`: positions of pieces of stripes that no line continues, m.
  void find(const FieldImage& seen, std::span<const Eigen::Vector2d> lone, FieldPercept& percept) const;

 private:
  std::optional<PenaltyMark> mark_at(const FieldImage& seen, const Eigen::Vector2d& place) const;
  bool is_white(const FieldImage& seen, const Eigen::Vector2d& center, double carpet) const;

  FieldFeatureParameters parameters_;
  double size_ = 0.0;  ///< m
};

}  // namespace reorient
