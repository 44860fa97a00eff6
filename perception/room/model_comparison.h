// SPDX-License-Identifier: MIT
// Two models of one room: where they differ, whether they count the wall from the same end of the field, and one that
// is made of both.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/saved_model.h"

namespace reorient {

struct TileDifference {
  int tile = 0;
  double distance = 0.0;  ///< Hellinger, in [0, 1]
};

/// A tile is known to a model that was trained on it for BackgroundParameters::trusted_after, by default.
struct ModelComparison {
  std::vector<TileDifference> tiles;  ///< that both know, by how much they differ, the most first
  int only_first = 0;                 ///< tiles that the one knows and the other does not
  int only_second = 0;
  std::optional<double> mean;  ///< over those that both know; nothing where there are none

  /// The mean differences over the tiles of which the second one knows the reflection, too: as it is, and turned by
  /// half a turn. Nothing where there are no such tiles.
  struct Sides {
    double as_it_is = 0.0;
    double turned = 0.0;
  };
  std::optional<Sides> sides;

  /// The second looks like the first, turned by half a turn.
  bool is_turned() const { return sides && is_clear(sides->turned, sides->as_it_is); }
  /// As it is, it looks like the first. Of two rooms it does neither.
  bool is_same_way() const { return sides && is_clear(sides->as_it_is, sides->turned); }

 private:
  /// By as little as by which a room must differ from its reflection to be told from it
  /// (RoomStatusParameters::distinctiveness), and by more than chance makes of two rooms that have nothing in common:
  /// of one hall on two days the one mean is 0.2 to 0.65 of the other, of two halls 0.9.
  static bool is_clear(double nearer, double farther) { return farther - nearer > 0.05 && nearer < 0.8 * farther; }
};

/// Both have the same basis.
ModelComparison compare(const SavedModel& first, const SavedModel& second);

/// Of both together: each tile as if it had been looked at as often as the two were, one look weighing as much as
/// another. Both have the same basis.
SavedModel merged(const SavedModel& first, const SavedModel& second);

}  // namespace reorient
