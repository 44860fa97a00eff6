// SPDX-License-Identifier: MIT
// The view filter on a grid (Markov localization over the azimuth; Fox, Burgard and Thrun, 1999): cells all around the
// wall, each with its share of the belief.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "perception/room/view/view_cluster.h"
#include "perception/room/view/view_filter_parameters.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {

/// A cell, as others see it.
struct ViewCell {
  double azimuth = 0.0;  ///< of its middle, rad in (-pi, pi]
  double share = 0.0;    ///< of the whole belief
};
template <typename Visit, ConstOr<ViewCell> T>
void fields(Visit&& visit, T& cell) {
  visit(cell.azimuth, cell.share);
}

/// The cells ride along with the camera: a turn moves the first cell's azimuth and leaves the shares as they are. Cells
/// that stood still would have to be interpolated in every frame, which blurs the belief more than its noise does, and
/// half a turn would be exact for an even number of them only.
class ViewGrid {
 public:
  /// So many cells with the same share each.
  void spread(int cells);
  /// The wall's azimuths are counted from the other end of the field.
  void turn_half();
  /// Moves the belief by `motion` (rad) and blurs it by the noise of `step` seconds.
  void predict(double motion, double step, const ViewFilterParameters& parameters);
  /// Bayes' rule with the likelihood exp(-sharpness step (distance - least)), then the leak: with a small probability
  /// the camera looks anywhere. `view_center`: where the belief says that the camera looks, rad. Without evidence in
  /// the scores the shares stay.
  void correct(const ViewpointScores& scores, double view_center, double step, const ViewFilterParameters& parameters);

  std::size_t cells() const { return shares_.size(); }
  /// Cells count to the left.
  ViewCell cell(std::size_t i) const;
  /// Share of the belief within `half_width` of an azimuth, both rad: even within a cell.
  double share_near(double azimuth, double half_width) const;
  /// Appends each run of cells that hold more than twice what they would if nothing were known.
  void find_clusters(std::vector<ViewCluster>& clusters) const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t count = self.shares_.size();
    archive(self.first_, self.shares_);
    if constexpr (Archive::kReads) self.check(count);
  }

 private:
  double width() const;  // rad
  void check(std::size_t count) const;
  void blur(double variance);

  double first_ = 0.0;  // azimuth of the middle of the first cell (azimuth.h), rad
  std::vector<double> shares_;
  std::vector<double> weights_;
};

}  // namespace reorient
