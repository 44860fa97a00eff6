// SPDX-License-Identifier: MIT
// The view filter (the paper's Section 3.4): a belief of where on the wall the camera looks, by particles as in the
// paper or on a grid.
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

/// Azimuths (azimuth.h) are in the field frame, rad in (-pi, pi]; the height follows the camera.
class ViewFilter {
 public:
  explicit ViewFilter(std::uint64_t seed) : particles_(seed) {}

  /// Nothing is known: a belief all around, evenly, by the method and as fine as the parameters say.
  void spread(const ViewFilterParameters& parameters);
  /// Whether the belief is by that method, and as fine.
  bool is_made_for(const ViewFilterParameters& parameters) const;
  /// The wall's azimuths are counted from the other end of the field.
  void turn_half();
  /// The camera turned by `motion` (rad), as far as anybody knows: the belief follows, and blurs by the noise of `step`
  /// seconds.
  void predict(double motion, double step, const ViewFilterParameters& parameters);
  /// The belief goes to where the scores are good. `view_center`: where the pose filter's belief says that the camera
  /// looks, rad. Without evidence in the scores it stays.
  void correct(const ViewpointScores& scores, double view_center, double step, const ViewFilterParameters& parameters);

  /// Share of the belief within `half_width` of an azimuth; both rad.
  double share_near(double azimuth, double half_width) const;
  /// Where it gathers, heaviest first.
  std::span<const ViewCluster> clusters() const { return clusters_; }
  void find_clusters();

  /// What the belief is made of; of the method that is not used, empty.
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
