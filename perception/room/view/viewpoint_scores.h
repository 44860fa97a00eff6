// SPDX-License-Identifier: MIT
// How well each viewpoint on the wall would explain what is perceived (the paper's Section 3.4).
#pragma once

#include <span>
#include <vector>

#include "perception/room/compared_model.h"
#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// One viewpoint cell: the camera looks `turn` columns further to the left than the belief says.
struct ViewpointScore {
  double distance = 0.0;  ///< mean over the tiles that were compared; that of the known cells where `known` is false
  int compared = 0;       ///< perceived tiles with a trusted model tile
  bool known = false;     ///< enough of them
};

/// A perceived tile, compared with what is known of the wall. Distances are not capped.
struct ComparedPlace {
  int tile = 0;                  ///< where the belief says that it is
  double as_believed = 0.0;      ///< distance to the model's tile there, in the light of the believed pose
  double as_reflected = 0.0;     ///< distance to the reflected tile, in the light of the reflection
  bool believed_known = false;   ///< the model's tile is trusted; otherwise the distance is 0
  bool reflected_known = false;  ///< the same of the reflected tile
};

/// A score for every whole number of columns by which the believed direction may be wrong, each in the light of the
/// pose or of its reflection, whichever is nearer.
///
/// From another place than where it was learned, a part of the room that is not as far away as the virtual wall appears
/// beside its tile (parallax). A camera sees a small part of the room, whose tiles move together. So the places are
/// compared where all of the view fits best, at most `tolerance` columns beside the believed direction, and where it
/// fits best beside the opposite one.
class ViewpointScores {
 public:
  void compute(std::span<const PerceivedTile> perceived, const ComparedModel& model, const Wall& wall,
               const Comparison& comparison, int tolerance);
  void clear();

  /// The cell `turn` columns to the left of the belief; any whole number.
  const ViewpointScore& at(int turn) const;
  /// Interpolated between the two nearest cells. `turn`: columns, any number.
  double distance(double turn) const;
  /// The perceived tiles that count and of which the model's tile or its reflection is trusted.
  std::span<const ComparedPlace> places() const { return places_; }
  int columns() const { return static_cast<int>(cells_.size()); }
  int best() const { return best_; }
  double least() const { return columns() > 0 ? at(best_).distance : 0.0; }
  /// How far the best cell is ahead of the average of the known ones: 0 where all look the same.
  double lead() const { return average_ - least(); }
  /// Whether this frame can tell the believed direction from the opposite one: a view that predicts nothing is
  /// no evidence, so both must be known.
  bool evidence() const { return evidence_; }

 private:
  struct Perceived {
    int tile;
    ComparedHistogram histogram, reflected_histogram;
  };

  void compare(const Perceived& perceived, const ComparedModel& model, const Wall& wall, const Comparison& comparison);
  int best_about(int turn, int tolerance) const;
  void find_places(int tolerance);

  static constexpr double kUnknown = -1.0;  // less than any distance

  std::vector<ViewpointScore> cells_;
  std::vector<ComparedPlace> places_;
  std::vector<int> compared_tiles_;     // where the belief says that they are
  std::vector<double> tile_distances_;  // of each of them the distance in each cell, or kUnknown
  std::vector<int> turns_;  // of the tiles in a row that are trusted, their histograms, and how far they are away
  std::vector<const ComparedHistogram*> models_;
  std::vector<double> distances_;
  int best_ = 0;
  double average_ = 0.0;
  bool evidence_ = false;
};

}  // namespace reorient
