// SPDX-License-Identifier: MIT
// How well each viewpoint on the wall explains the perceived tiles (the paper's Section 3.4).
#pragma once

#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "perception/room/compared_model.h"
#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// One viewpoint cell: the camera looks `turn` columns farther to the left than in the belief.
struct ViewpointScore {
  double distance = 0.0;  ///< mean over the compared tiles; the mean of the known cells if `known` is false
  int compared = 0;       ///< perceived tiles with a trusted model tile
  bool known = false;     ///< whether enough tiles were compared
};

/// A perceived tile with its distances to the model of the wall. Distances are not capped.
struct ComparedPlace {
  int tile = 0;                  ///< position according to the belief
  double as_believed = 0.0;      ///< distance to the model's tile at this position, in the light of the believed pose
  double as_reflected = 0.0;     ///< distance to the reflected tile, in the light of the reflection
  bool believed_known = false;   ///< the model's tile is trusted; otherwise the distance is 0
  bool reflected_known = false;  ///< the same for the reflected tile
};
template <typename Visit, ConstOr<ComparedPlace> T>
void fields(Visit&& visit, T& place) {
  visit(place.tile, place.as_believed, place.as_reflected, place.believed_known, place.reflected_known);
}

/// One score for each integer number of columns by which the believed direction may be wrong. It uses the light of the
/// pose or of its reflection, whichever is nearer.
///
/// From another position than during training, an object that is not at the distance of the virtual wall appears beside
/// its tile (parallax). A camera sees a small part of the room, whose tiles move together. So the two tiles are
/// compared at the best fit of the whole view: at most `tolerance` columns from the believed direction, and from the
/// opposite one.
class ViewpointScores {
 public:
  void compute(std::span<const PerceivedTile> perceived, const ComparedModel& model, const Wall& wall,
               const Comparison& comparison, int tolerance);
  void clear();

  /// The cell `turn` columns to the left of the belief; any integer.
  const ViewpointScore& at(int turn) const;
  /// Interpolated between the two nearest cells. `turn`: columns, any number.
  double distance(double turn) const;
  /// The perceived tiles that count and whose model tile, or its reflection, is trusted.
  std::span<const ComparedPlace> places() const { return places_; }
  int columns() const { return static_cast<int>(cells_.size()); }
  int best() const { return best_; }
  double least() const { return columns() > 0 ? at(best_).distance : 0.0; }
  /// Lead of the best cell over the average of the known cells. 0 if all are the same.
  double lead() const { return average_ - least(); }
  /// Whether this frame can distinguish the believed direction from the opposite one. An unknown view is no evidence,
  /// so both must be known.
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
  std::vector<int> compared_tiles_;     // positions according to the belief
  std::vector<double> tile_distances_;  // for each of them, the distance in each cell, or kUnknown
  std::vector<int> turns_;              // trusted tiles of a row, their histograms, and their distances in columns
  std::vector<const ComparedHistogram*> models_;
  std::vector<double> distances_;
  int best_ = 0;
  double average_ = 0.0;
  bool evidence_ = false;
};

}  // namespace reorient
