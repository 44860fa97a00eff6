// SPDX-License-Identifier: MIT
// Tests whether the room looks the same after a rotation by 180 degrees. Then it cannot distinguish a pose from its
// reflection.
#pragma once

#include <vector>

#include "geometry/const_or.h"
#include "perception/room/compared_model.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// A statistical test of the model of the wall against the same model, rotated. The difference between a tile and its
/// reflection is not sufficient. From the robot's position, the two ends of a symmetric room look different, too, and
/// in a colorless room all tiles are similar. But a symmetric room differs less from itself after a rotation by 180
/// degrees than after 45 or 135 degrees, at which no room with two or four equal sides repeats itself.
///
/// With H and O the mean differences after a rotation by 180 degrees and by odd multiples of 45 degrees, and m the
/// misfit, which is the difference between a tile and its next view from a known pose, the test uses the ratio of the
/// differences beyond the misfit:
///
///     s = (max(H - 0.7 m, 0) + 0.8 t) / (max(O - 0.7 m, 0) + t),   t = 0.03
///
/// It is 1 in a room without repetition, and 0.8 (a value from experience) in an unknown room. Its variance consists of
/// a jackknife over eight parts of the wall, a term for the number of tiles, and a term for the weight of experience in
/// it. docs/decisions.md explains how the numbers were found.
///
/// Each tile is compared with the nearest of the tiles within 7.5 degrees of its rotated position, since from another
/// position, objects behind the virtual wall appear at another azimuth of it.
class Separability {
 public:
  /// Starts without knowledge of the misfit and of a wall with this many columns.
  void restart(int columns);
  /// Adds a view of known tiles from a known pose, before they are learned: their mean difference to the model
  /// (Hellinger) and its duration, s.
  void note_misfit(double difference, double step);
  /// Must be called once for each frame. Compares the next column of the wall, cyclically. The result is at most a few
  /// seconds old.
  void observe(const ComparedModel& model, const Wall& wall);
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees();

  /// Probability, 0 to 1, that the room distinguishes a pose from its mirrored pose: that s is above 0.6.
  double probability() const { return probability_; }
  /// Weight of the evidence at this probability: 0 if it is at most one half, 1 if it is 1.
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
    double half = 0.0;     // of the differences after 180 degrees
    double eighths = 0.0;  // of the mean differences of a tile after odd multiples of 45 degrees
    int tiles = 0;
    Column& operator+=(const Column& other);
  };
  template <typename Visit, ConstOr<Column> T>
  friend void fields(Visit&& visit, T& column) {
    visit(column.half, column.eighths, column.tiles);
  }

  void check(std::size_t columns) const;
  void summarize();
  double ratio(const Column& sums) const;

  std::vector<Column> columns_;
  int next_ = 0;
  double misfit_ = 0.0;
  double misfit_age_ = 0.0;  // s of views in this mean, at most its time constant
  double probability_ = 0.0;
};

}  // namespace reorient
