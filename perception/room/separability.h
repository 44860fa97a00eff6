// SPDX-License-Identifier: MIT
// Does the room look the same after half a turn? Then nothing in it can tell a pose from its reflection.
#pragma once

#include <vector>

#include "geometry/const_or.h"
#include "perception/room/compared_model.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// A statistical test of the model of the wall against the same model, rotated. The difference between a tile and its
/// reflection is not enough: from where the robot stood, the two ends of a symmetric room looked different, too, and in
/// a colorless room all tiles are similar. But a room that repeats itself after half a turn differs less from itself
/// after half a turn than after one or three eighths of a turn, at which no room with two or four equal sides repeats
/// itself.
///
/// With H and O the mean differences after half a turn and after the odd eighths of a turn, and m the misfit, by which
/// a tile differs from its own next look although the pose is known, the test is about the share of what differs beyond
/// the misfit:
///
///     s = (max(H - 0.7 m, 0) + 0.8 t) / (max(O - 0.7 m, 0) + t),   t = 0.03
///
/// It is 1 in a room in which nothing is repeated, and 0.8, as experience has it, in one of which nothing is known. Its
/// variance is that of a jackknife over eight parts of the wall, and of the number of tiles and of the share of
/// experience in it. docs/decisions.md says how the numbers were found.
///
/// Each tile is compared with the nearest of the tiles within 7.5 degrees of where the turn leads, since what lies
/// behind the virtual wall is seen elsewhere on it from another place.
class Separability {
 public:
  /// Nothing is known of a wall with this many columns, nor of the misfit.
  void restart(int columns);
  /// A look at known tiles from a known pose, before it is learned: their mean difference to the model (Hellinger), and
  /// for how long it was looked, s.
  void note_misfit(double difference, double step);
  /// Once a frame: compares the next column of the wall, in turn. The result is at most a few seconds old.
  void observe(const ComparedModel& model, const Wall& wall);
  /// The wall's tiles are counted from the other end of the field.
  void turn_half();

  /// Probability, 0 to 1, that the room can tell a pose from its reflection: that s is above 0.6.
  double probability() const { return probability_; }
  /// What the evidence is worth then: 0 where it is as likely that the room cannot, 1 where it certainly can.
  double weight() const { return probability_ > 0.5 ? 2.0 * probability_ - 1.0 : 0.0; }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t columns = self.columns_.size();
    archive(self.columns_, self.next_, self.misfit_, self.misfit_age_, self.probability_);
    if constexpr (Archive::kReads) self.check(columns);
  }

 private:
  /// Sums over the tiles of a column that are known together with their reflections.
  struct Column {
    double half = 0.0;     // of the differences after half a turn
    double eighths = 0.0;  // of the mean differences of a tile after the odd eighths
    int tiles = 0;
    Column& operator+=(const Column& other);
  };
  template <typename Visit, ConstOr<Column> T>
  friend void fields(Visit&& visit, T& column) {
    visit(column.half, column.eighths, column.tiles);
  }

  void check(std::size_t columns) const;
  void summarize();
  double share(const Column& sums) const;

  std::vector<Column> columns_;
  int next_ = 0;
  double misfit_ = 0.0;
  double misfit_age_ = 0.0;  // s of looks that it is the mean of, up to its time constant
  double probability_ = 0.0;
};

}  // namespace reorient
