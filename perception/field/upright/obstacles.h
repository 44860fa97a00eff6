// SPDX-License-Identifier: MIT
// Objects on the carpet that are neither lines nor posts: robots, people.
#pragma once

#include <array>
#include <vector>

#include "perception/field/carpet/carpet_map.h"
#include "perception/field/ground_projection.h"
#include "perception/field/lines/known_lines.h"
#include "perception/field/percepts.h"

namespace reorient {

class Obstacles {
 public:
  explicit Obstacles(const FieldFeatureParameters& parameters);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Reads the percept's boundary, goal posts and ball, and sets its obstacles. An obstacle on a known line does not
  /// begin where the line does. Objects lower than `least_height` (m) are not obstacles.
  void find(const CarpetMap& map, const GroundProjection& view, const KnownLines& lines, double least_height,
            FieldPercept& percept);

 private:
  /// The lowest stretch of a column that is not carpet.
  struct Foot {
    int row = -1;           ///< pixels, lowest row of the object; negative: no object
    double distance = 0.0;  ///< m
  };
  double farthest_in(const CarpetMap& map, const GroundProjection& view, const FieldPercept& percept, int column) const;
  Foot foot_in(const CarpetMap& map, const GroundProjection& view, const FieldPercept& percept, int column,
               int first_row, double least_height) const;
  int above_line(const CarpetMap& map, const GroundProjection& view, const KnownLines& lines, int column,
                 int row) const;
  bool is_sure(const CarpetMap& map, const GroundProjection& view, const FieldPercept& percept, int first,
               int last) const;
  void add(const CarpetMap& map, const GroundProjection& view, int first, int last, FieldPercept& percept) const;

  FieldFeatureParameters parameters_;
  std::array<double, CarpetMap::kColumns> farthest_{};  ///< of the image being searched, as farthest_in() returns
  std::array<Foot, CarpetMap::kColumns> feet_{};
};

}  // namespace reorient
