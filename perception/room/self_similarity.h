// Does the room look the same after half a turn? Then nothing in it can tell a pose from its reflection.
#pragma once

#include <vector>

#include "perception/room/compared_model.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// Compares the wall with itself, turned. How much a tile differs from its reflection says little: from where the robot
/// stood, the two ends of a symmetric room looked different, too, and in a colourless room everything looks alike. But
/// where the room repeats itself after half a turn, it is then nearer to itself than after an eighth of a turn or
/// three, at which no room with two or four equal sides repeats itself.
///
/// Each tile is compared with the nearest of the tiles within 7.5 degrees of where the turn leads, since what lies
/// behind the virtual wall is seen elsewhere on it from another place.
class SelfSimilarity {
 public:
  /// Nothing is known of a wall with this many columns.
  void restart(int columns);
  /// Once a frame: the next column of the wall, in turn. So what is told is at most a few seconds old.
  void observe(const ComparedModel& model, const Wall& wall);
  /// The wall's tiles are counted from the other end of the field.
  void turn_half();

  /// The mean difference after half a turn as a share of that after the odd eighths of a turn, of the same tiles: about
  /// 1 in a room in which nothing is repeated, at most 0.78 in those that were made symmetric. The two are not wholly
  /// apart: of ten real rooms one comes down to 0.69 where a body that stands still has learned it. 1 as long as too
  /// little is known, and of a wall with fewer than 8 columns.
  double asymmetry() const { return asymmetry_; }

  /// Throws BadBytes.
  template <typename Archive>
  void archive(Archive& archive) {
    const std::size_t columns = columns_.size();
    archive(columns_, next_, asymmetry_);
    if constexpr (Archive::kReads) check(columns);
  }

 private:
  /// Sums over the tiles of a column that are known together with their reflections.
  struct Column {
    double half = 0.0;     // of the differences after half a turn
    double eighths = 0.0;  // of the mean differences of a tile after the odd eighths
    int tiles = 0;
  };
  template <typename Visit>
  friend void fields(Visit&& visit, Column& column) {
    visit(column.half, column.eighths, column.tiles);
  }

  void check(std::size_t columns) const;
  void summarize();

  std::vector<Column> columns_;
  int next_ = 0;
  double asymmetry_ = 1.0;
};

}  // namespace reorient
