// SPDX-License-Identifier: MIT
// The view filter on a grid (Markov localization over the azimuth; Fox, Burgard and Thrun, 1999): cells all around the
// wall, each with a fraction of the belief.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "perception/room/view/view_cluster.h"
#include "perception/room/view/view_filter_parameters.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {

/// A cell in the form that other parts use.
struct ViewCell {
  double azimuth = 0.0;  ///< of its center, rad in (-pi, pi]
  double share = 0.0;    ///< fraction of the whole belief
};
template <typename Visit, ConstOr<ViewCell> T>
void fields(Visit&& visit, T& cell) {
  visit(cell.azimuth, cell.share);
}

/// The cells move with the camera: a rotation changes the first cell's azimuth and no cell's fraction. Fixed cells
/// would need interpolation in each frame, which would blur the belief more than its noise does. A rotation by 180
/// degrees would be exact only for an even number of fixed cells.
class ViewGrid {
 public:
  /// This number of cells, all with the same fraction.
  void spread(int cells);
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees();
  /// Moves the belief by `motion` (rad) and blurs it by the noise of `step` seconds.
  void predict(double motion, double step, const ViewFilterParameters& parameters);
  /// Applies Bayes' rule with the likelihood exp(-sharpness step (distance - least)), then the leak: with a small
  /// probability the camera looks anywhere. `view_center`: azimuth of the camera according to the belief, rad. Without
  /// evidence in the scores, the fractions are unchanged.
  void correct(const ViewpointScores& scores, double view_center, double step, const ViewFilterParameters& parameters);

  std::size_t cells() const { return fractions_.size(); }
  /// Cells count to the left.
  ViewCell cell(std::size_t i) const;
  /// Fraction of the belief within `half_width` of an azimuth, both rad. It is assumed uniform within a cell.
  double share_near(double azimuth, double half_width) const;
  /// Appends each run of cells with more than twice their fraction in a uniform belief.
  void find_clusters(std::vector<ViewCluster>& clusters) const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t count = self.fractions_.size();
    archive(self.first_, self.fractions_);
    if constexpr (Archive::kReads) self.check(count);
  }

 private:
  double width() const;  // rad
  void check(std::size_t count) const;
  void blur(double variance);

  double first_ = 0.0;  // azimuth of the center of the first cell (azimuth.h), rad
  std::vector<double> fractions_;
  std::vector<double> weights_;
};

}  // namespace reorient
