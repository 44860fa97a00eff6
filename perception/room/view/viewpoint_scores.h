// How well each viewpoint on the wall would explain what is perceived (the paper's Section 3.4).
#pragma once

#include <span>
#include <vector>

#include "perception/room/background_model.h"
#include "perception/room/color/histogram_distance.h"
#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// How two histograms are compared in the mode that is on.
struct Comparison {
  Distance measure = Distance::hellinger;
  double cap = 0.5;            ///< no tile counts as more different than this
  double trusted_after = 0.3;  ///< s of training that a tile needs
};

/// The model, prepared for comparing.
class ComparedModel {
 public:
  void prepare(const BackgroundModel& model, const Comparison& comparison);
  bool trusted(int tile) const { return trusted_[static_cast<std::size_t>(tile)] != 0; }
  const ComparedHistogram& operator[](int tile) const { return tiles_[static_cast<std::size_t>(tile)]; }
  /// Share of all tiles that are trusted.
  double coverage() const;

 private:
  std::vector<ComparedHistogram> tiles_;
  std::vector<char> trusted_;
};

/// One viewpoint cell: the camera looks `turn` columns further to the left than the belief says.
struct ViewpointScore {
  double distance = 0.0;  ///< mean over the tiles that were compared; that of the known cells where `known` is false
  int compared = 0;       ///< perceived tiles with a trusted model tile
  bool known = false;     ///< enough of them
};

/// A score for every whole number of columns by which the believed direction may be wrong.
class ViewpointScores {
 public:
  void compute(std::span<const PerceivedTile> perceived, const ComparedModel& model, const Wall& wall,
               const Comparison& comparison);
  void clear();

  /// The cell `turn` columns to the left of the belief; any whole number.
  const ViewpointScore& at(int turn) const;
  /// Interpolated between the two nearest cells. `turn`: columns, any number.
  double distance(double turn) const;
  int columns() const { return static_cast<int>(cells_.size()); }
  int best() const { return best_; }
  double least() const { return columns() > 0 ? at(best_).distance : 0.0; }
  /// How far the best cell is ahead of the average of the known ones: 0 where all look the same.
  double lead() const { return average_ - least(); }
  /// Whether this frame can tell the believed direction from the opposite one: a view that predicts nothing is
  /// no evidence, so both must be known.
  bool evidence() const { return evidence_; }

 private:
  std::vector<ViewpointScore> cells_;
  std::vector<ComparedHistogram> perceived_;
  std::vector<int> places_;
  int best_ = 0;
  double average_ = 0.0;
  bool evidence_ = false;
};

}  // namespace reorient
