// SPDX-License-Identifier: MIT
// The view filter as in the paper (Section 3.4): its particles are hypotheses where on the wall the camera looks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "geometry/random.h"
#include "perception/room/view/view_cluster.h"
#include "perception/room/view/view_filter_parameters.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {

/// A viewpoint: an azimuth of the wall (azimuth.h), rad in (-pi, pi], field frame. The height follows the camera.
struct ViewParticle {
  double azimuth = 0.0;
  double weight = 0.0;  ///< of this frame, before resampling; the sum of all weights is 1
};
template <typename Visit, ConstOr<ViewParticle> T>
void fields(Visit&& visit, T& particle) {
  visit(particle.azimuth, particle.weight);
}

class ViewParticles {
 public:
  explicit ViewParticles(std::uint64_t seed) : random_(seed, 0x766965775F66696Cull) {}

  /// This number of particles, evenly distributed over all azimuths.
  void spread(int particles);
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees();
  /// Moves all particles by `motion` (rad) and scatters them by the noise of `step` seconds.
  void predict(double motion, double step, const ViewFilterParameters& parameters);
  /// Weights, resamples (systematically) and injects particles at the best match. `view_center`: azimuth of the camera
  /// according to the belief, rad. Without evidence in the scores, all weights are the same.
  void correct(const ViewpointScores& scores, double view_center, double step, const ViewFilterParameters& parameters);

  std::span<const ViewParticle> particles() const { return particles_; }
  /// Fraction of the particles within `half_width` of an azimuth; both rad.
  double share_near(double azimuth, double half_width) const;
  /// Appends the groups that are separated by gaps.
  void find_clusters(std::vector<ViewCluster>& clusters);

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t count = self.particles_.size();
    archive(self.random_, self.particles_);
    if constexpr (Archive::kReads) self.check(count);
  }

 private:
  void check(std::size_t count) const;
  void resample();
  void inject(double azimuth, double half_width, double expected);

  Random random_;
  std::vector<ViewParticle> particles_;
  std::vector<ViewParticle> resampled_;
  std::vector<double> weights_;
  std::vector<double> sorted_;
  std::vector<double> sines_;
  std::vector<double> cosines_;
};

}  // namespace reorient
