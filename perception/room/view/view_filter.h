// SPDX-License-Identifier: MIT
// The view filter (the paper's Section 3.4): a belief where on the wall the camera looks, represented by particles as
// in the paper, or by a grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bytes.h"
#include "perception/room/view/view_cluster.h"
#include "perception/room/view/view_filter_parameters.h"
#include "perception/room/view/view_grid.h"
#include "perception/room/view/view_particles.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {

/// Azimuths (azimuth.h) are in the field frame, rad in (-pi, pi]. The height follows the camera.
class ViewFilter {
 public:
  explicit ViewFilter(std::uint64_t seed) : particles_(seed) {}

  /// Resets the belief to a uniform one, with the method and the resolution of the parameters.
  void spread(const ViewFilterParameters& parameters);
  /// Whether the belief has the method and the resolution of the parameters.
  bool is_made_for(const ViewFilterParameters& parameters) const;
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees();
  /// Moves the belief by the camera's measured rotation `motion` (rad), and blurs it by the noise of `step` seconds.
  void predict(double motion, double step, const ViewFilterParameters& parameters);
  /// Moves the belief toward good scores. `view_center`: azimuth of the camera according to the believed pose, rad.
  /// Without evidence in the scores, the belief is unchanged.
  void correct(const ViewpointScores& scores, double view_center, double step, const ViewFilterParameters& parameters);

  /// Fraction of the belief within `half_width` of an azimuth; both rad.
  double share_near(double azimuth, double half_width) const;
  /// The clusters of the belief, largest first.
  std::span<const ViewCluster> clusters() const { return clusters_; }
  void find_clusters();

  /// The representation of the belief. Empty for the method that is not used.
  std::span<const ViewParticle> particles() const { return particles_.particles(); }
  const ViewGrid& grid() const { return grid_; }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    ViewMethod method = self.method_;
    archive(method, self.particles_, self.grid_, self.clusters_);
    if constexpr (Archive::kReads) self.check(method);
  }

 private:
  bool on_grid() const { return method_ == ViewMethod::grid; }
  void check(ViewMethod method) const;

  ViewMethod method_ = ViewFilterParameters().method;
  ViewParticles particles_;
  ViewGrid grid_;
  std::vector<ViewCluster> clusters_;
};

}  // namespace reorient
