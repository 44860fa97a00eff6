// SPDX-License-Identifier: MIT
// A small wall that is fully known.
#pragma once

#include <vector>

#include "perception/room/view/viewpoint_scores.h"

namespace reorient {

/// A wall with one row in which each column has different colors, and the tiles that a camera perceives.
struct OneRow {
  static constexpr double kTrained = 60.0;  // s, each column
  OneRow() {
    WallParameters shape;
    shape.rows = 1;
    shape.columns = 16;
    wall = Wall(shape);
    model.forget(16);
    for (int column = 0; column < 16; ++column) model.train(column, colors_of(column), {kTrained, 100.0, true, 0.0});
    compared.prepare(model, wall, comparison);
  }
  static ColorHistogram colors_of(int column) {
    ColorHistogram histogram{};
    histogram[static_cast<std::size_t>(column % 14)] = 0.7f;
    histogram[static_cast<std::size_t>((3 * column + 1) % 14)] += 0.3f;
    return histogram;
  }
  /// The scores if the believed view shows columns first...first + 3, and the true view is `turn` columns to the left.
  ViewpointScores scores(int first, int turn, int tolerance = 0) const {
    std::vector<PerceivedTile> perceived;
    for (int column = first; column < first + 4; ++column) {
      PerceivedTile tile;
      tile.tile = column % 16;
      tile.counts = true;
      tile.histogram = tile.reflected_histogram = colors_of((column + turn) % 16);
      perceived.push_back(tile);
    }
    ViewpointScores result;
    result.compute(perceived, compared, wall, comparison, tolerance);
    return result;
  }
  Wall wall;
  BackgroundModel model;
  Comparison comparison;
  ComparedModel compared;
};

}  // namespace reorient
