// SPDX-License-Identifier: MIT
// Comparison of two models of one room: where they differ, and whether their axes have the same direction. Also merges
// two models.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/saved_model.h"

namespace reorient {

struct TileDifference {
  int tile = 0;
  double distance = 0.0;  ///< Hellinger, in [0, 1]
};

/// A tile is known to a model that was trained on it for at least the default of BackgroundParameters::trusted_after.
struct ModelComparison {
  std::vector<TileDifference> tiles;  ///< tiles that both know, sorted by their difference, largest first
  int only_first = 0;                 ///< tiles that only one of them knows
  int only_second = 0;
  std::optional<double> mean;  ///< mean over the tiles that both know; empty if there are no such tiles

  /// Mean differences over the tiles whose reflection the second model also knows: unrotated, and rotated by 180
  /// degrees. Empty if there are no such tiles.
  struct Sides {
    double as_it_is = 0.0;
    double turned = 0.0;
  };
  std::optional<Sides> sides;

  /// Mean difference between different parts of one room, as the two models know them (their geometric mean). Two
  /// models of different rooms differ as much. Empty if a model knows too little.
  std::optional<double> spread;

  /// Whether both models show one room, in either direction. In ten real rooms and three simulated halls, in two
  /// lights, the difference between models of one room was 0.2 to 0.57 of the spread, or up to 0.75 if one was learned
  /// for 12 s only. Between models of two rooms it was at least 0.84.
  bool is_of_one_room() const;
  /// Whether the second model matches the first one after a rotation by 180 degrees.
  bool is_turned() const { return sides && is_clear(sides->turned, sides->as_it_is); }
  /// Whether the second model matches the first one without rotation. For two different rooms, either may be true.
  bool is_same_way() const { return sides && is_clear(sides->as_it_is, sides->turned); }

 private:
  /// The difference between the two means must be as large as the smallest difference between a distinguishable room
  /// and its reflection (RoomStatusParameters::distinctiveness). It must also be larger than chance produces for two
  /// unrelated rooms. For one hall on two days, the smaller mean is 0.2 to 0.65 of the larger one; for two halls, it is
  /// 0.9.
  static bool is_clear(double nearer, double farther) { return farther - nearer > 0.05 && nearer < 0.8 * farther; }
};

/// Both models must have the same basis.
ModelComparison compare(const SavedModel& first, const SavedModel& second);

/// Merges both models: each tile as if one model had seen all visits of both, with the same weight for each visit. Both
/// models must have the same basis.
SavedModel merged(const SavedModel& first, const SavedModel& second);

}  // namespace reorient
