// SPDX-License-Identifier: MIT
// The background model, made ready to be compared with.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/background_model.h"
#include "perception/room/color/histogram_distance.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// How two histograms are compared in the mode that is on.
struct Comparison {
  Distance measure = Distance::hellinger;
  double cap = 0.5;            ///< no tile counts as more different than this
  double trusted_after = 0.3;  ///< s of training that a tile needs
  bool operator==(const Comparison&) const = default;
};

class ComparedModel {
 public:
  /// Takes over the tiles that were trained since the last call.
  void prepare(const BackgroundModel& model, const Wall& wall, const Comparison& comparison);
  /// The next prepare() takes over all tiles: where the model was not trained, but replaced.
  void clear() { tiles_.clear(); }

  bool trusted(int tile) const { return tiles_[static_cast<std::size_t>(tile)].trusted; }
  const ComparedHistogram& operator[](int tile) const { return tiles_[static_cast<std::size_t>(tile)].histogram; }
  /// How much two tiles that are trusted differ, in [0, 1]: the Hellinger distance, the same scale in every mode and
  /// for every measure.
  double difference(int tile, int other) const {
    return distance(Distance::hellinger, tiles_[static_cast<std::size_t>(tile)].roots,
                    tiles_[static_cast<std::size_t>(other)].roots);
  }
  /// The same of a tile and its reflection; nothing where one of the two is not trusted.
  std::optional<double> difference_to_reflection(int tile) const {
    return tiles_[static_cast<std::size_t>(tile)].difference;
  }

  /// For how long a tile was trained, and its reflection, s.
  double trained(int tile) const { return tiles_[static_cast<std::size_t>(tile)].trained; }
  double reflection_trained(int tile) const { return tiles_[static_cast<std::size_t>(tile)].reflection_trained; }

  /// Share of all tiles that are trusted.
  double coverage() const { return coverage_; }
  /// Share of all tiles that are trusted together with their reflections.
  double paired() const { return paired_; }
  /// Whether the room can tell a pose from its reflection at all: the mean difference over the tiles that are trusted
  /// on both sides; 0 where there are none, and where the room looks the same after half a turn.
  double distinctiveness() const { return distinctiveness_; }

 private:
  struct Tile {
    ComparedHistogram histogram;
    ComparedHistogram roots;          // for the Hellinger distance
    int visits = -1;                  // of the model's tile that it was made from
    double trained = 0.0;             // s, the same
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
