// SPDX-License-Identifier: MIT
// The background model, prepared for comparisons.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/background_model.h"
#include "perception/room/color/histogram_distance.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// How two histograms are compared in the current mode.
struct Comparison {
  Distance measure = Distance::hellinger;
  double cap = 0.5;            ///< largest distance of a tile; greater distances are reduced to it
  double trusted_after = 0.3;  ///< s of training before a tile is used for comparisons
  bool operator==(const Comparison&) const = default;
};

class ComparedModel {
 public:
  /// Copies the tiles that were trained since the last call.
  void prepare(const BackgroundModel& model, const Wall& wall, const Comparison& comparison);
  /// Makes the next prepare() copy all tiles, after the model was replaced and not trained.
  void clear() { tiles_.clear(); }
  /// Whether prepare() was not called since the last clear().
  bool is_empty() const { return tiles_.empty(); }

  bool trusted(int tile) const { return tiles_[static_cast<std::size_t>(tile)].trusted; }
  const ComparedHistogram& operator[](int tile) const { return tiles_[static_cast<std::size_t>(tile)].histogram; }
  /// Difference of two trusted tiles, in [0, 1]. It is the Hellinger distance, so the scale is the same in each mode
  /// and for each measure.
  double difference(int tile, int other) const {
    return distance(Distance::hellinger, tiles_[static_cast<std::size_t>(tile)].roots,
                    tiles_[static_cast<std::size_t>(other)].roots);
  }
  /// The same for a tile and its reflection. Empty if one of the two is not trusted.
  std::optional<double> difference_to_reflection(int tile) const {
    return tiles_[static_cast<std::size_t>(tile)].difference;
  }

  /// Training time of a tile and of its reflection, s.
  double trained(int tile) const { return tiles_[static_cast<std::size_t>(tile)].trained; }
  double reflection_trained(int tile) const { return tiles_[static_cast<std::size_t>(tile)].reflection_trained; }

  /// Fraction of all tiles that are trusted.
  double coverage() const { return coverage_; }
  /// Fraction of all tiles that are trusted together with their reflections.
  double paired() const { return paired_; }
  /// Whether the room distinguishes a pose from its mirrored pose: the mean difference over the tiles that are trusted
  /// on both sides. It is 0 if there are no such tiles, and if the room looks the same after a rotation by 180 degrees.
  double distinctiveness() const { return distinctiveness_; }

 private:
  struct Tile {
    ComparedHistogram histogram;
    ComparedHistogram roots;          // for the Hellinger distance
    int visits = -1;                  // of the tile of the model from which it was copied
    double trained = 0.0;             // s, of that tile
    double reflection_trained = 0.0;  // s
    std::optional<double> difference;
    bool trusted = false;
  };

  void summarize(const Wall& wall);

  std::vector<Tile> tiles_;
  Comparison comparison_;
  double coverage_ = 0.0;
  double paired_ = 0.0;
  double distinctiveness_ = 0.0;
};

}  // namespace reorient
