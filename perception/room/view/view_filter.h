// The view filter (the paper's Section 3.4): particles that are hypotheses of where on the wall the camera looks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {

struct ViewFilterParameters {
  int particles = 100;
  double noise = 0.166;
  double sharpness = 150.0;
  double injection = 0.5;
  double clear_lead = 0.05;
};
template <typename Visit>
void describe(ViewFilterParameters& p, Visit&& visit) {
  visit("particles", p.particles, 10, 1000, "", "how many view particles");
  visit("noise", p.noise, 0.0, 2.0, "rad/s^0.5", "random walk of the particles: 0.166 is 3 degrees in 0.1 s");
  visit("sharpness", p.sharpness, 0.0, 5000.0, "1/s", "beta: how fast a worse match loses its particles");
  visit("injection", p.injection, 0.0, 10.0, "1/s",
        "share of the particles that are set to the best match: 0.5 is 5 % in 0.1 s");
  visit("clear_lead", p.clear_lead, 0.0, 1.0, "",
        "lead of the best match over the average from which on all of the injection happens; 0: always");
}

/// A viewpoint: an azimuth of the wall (azimuth.h), rad in (-pi, pi], field frame. The height follows the camera.
struct ViewParticle {
  double azimuth = 0.0;
  double weight = 0.0;  ///< of this frame, before resampling; the weights sum up to 1
};
template <typename Visit>
void fields(Visit&& visit, ViewParticle& particle) {
  visit(particle.azimuth, particle.weight);
}

/// Particles that lie together.
struct ViewCluster {
  double azimuth = 0.0;  ///< circular mean, rad
  double spread = 0.0;   ///< standard deviation, rad
  double share = 0.0;    ///< of all particles
};
template <typename Visit>
void fields(Visit&& visit, ViewCluster& cluster) {
  visit(cluster.azimuth, cluster.spread, cluster.share);
}

class ViewFilter {
 public:
  explicit ViewFilter(std::uint64_t seed) : random_(seed, 0x766965775F66696Cull) {}

  /// Particles all around, evenly.
  void spread(int particles);
  /// The wall's azimuths are counted from the other end of the field.
  void turn_half();
  /// Moves all of them by `motion` (rad) and scatters them by the noise of `step` seconds.
  void predict(double motion, double step, const ViewFilterParameters& parameters);
  /// Weighs, resamples (systematically) and injects at the best match. `view_center`: where the belief says that the
  /// camera looks, rad. Without evidence in the scores all weights are the same.
  void correct(const ViewpointScores& scores, double view_center, double step, const ViewFilterParameters& parameters);

  std::span<const ViewParticle> particles() const { return particles_; }
  /// Share of the particles that lie within `half_width` of an azimuth; both rad.
  double share_near(double azimuth, double half_width) const;
  /// Groups that are separated by gaps, heaviest first.
  std::span<const ViewCluster> clusters() const { return clusters_; }
  void find_clusters();

  /// Throws BadBytes.
  template <typename Archive>
  void archive(Archive& archive) {
    const std::size_t count = particles_.size();
    archive(random_, particles_, clusters_);
    if constexpr (Archive::kReads) check(count);
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
  std::vector<ViewCluster> clusters_;
};

}  // namespace reorient
