// SPDX-License-Identifier: MIT
// The belief of somebody else's localization, read as ours is: where it is given as particles, their heaviest cluster.
#pragma once

#include <optional>
#include <vector>

#include "geometry/const_or.h"
#include "geometry/field_dimensions.h"
#include "localization/particles/particle_set.h"
#include "localization/particles/pose_clusters.h"
#include "localization/pose_belief.h"
#include "robots/robot.h"

namespace reorient {

/// Particles beyond this many are left out.
inline constexpr std::size_t kMostExternalParticles = 10000;

struct ExternalBeliefParameters {
  double patience = 1.0;
};
template <typename Visit>
void describe(ExternalBeliefParameters& p, Visit&& visit) {
  visit("patience", p.patience, 0.0, 60.0, "s",
        "how long the last belief of another localization moves with the odometry if no belief can be read; then the "
        "robot continues with its own localization");
}

/// Whether the belief of another localization is used: what one frame leaves for the next.
struct ExternalUse {
  bool in_use = false;      ///< the belief of the frame before came from there
  double unread_for = 0.0;  ///< s for which none could be read since then
};
template <typename Visit, ConstOr<ExternalUse> T>
void fields(Visit&& visit, T& use) {
  visit(use.in_use, use.unread_for);
}

class ExternalBeliefReader {
 public:
  explicit ExternalBeliefReader(const FieldDimensions& field);

  /// `last`: what was believed before; where particles are spread over several clusters, its own keeps its place as
  /// with our pose filter. Nothing: there is no belief, or something in it is not finite, or is negative.
  std::optional<PoseBelief> read(const std::optional<ExternalBelief>& external, const PoseBelief& last,
                                 const PoseClusterParameters& parameters);

  /// Of what was read last: its particles, or the pose where there were none. Empty: it could not be read.
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  bool take_particles(std::span<const ExternalBelief::Particle> particles);

  Eigen::Vector2d half_size_;
  PoseClusters clusters_;
  ParticleSet particles_;
  std::vector<Pose2> poses_;
};

/// Somebody can act on it: it says which way the robot looks, and more or less where.
bool is_known(const PoseBelief& belief);

/// What the belief should become once a reorientation was carried out on it.
PoseBelief expected_after(Reorientation reorientation, const PoseBelief& belief);

}  // namespace reorient
