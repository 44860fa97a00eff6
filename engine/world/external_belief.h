// SPDX-License-Identifier: MIT
// Reads the belief of an external localization; of particles it uses the heaviest cluster.
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

/// Further particles are ignored.
inline constexpr std::size_t kMostExternalParticles = 10000;

struct ExternalBeliefParameters {
  double patience = 1.0;
};
template <typename Visit>
void describe(ExternalBeliefParameters& p, Visit&& visit) {
  visit("patience", p.patience, 0.0, 60.0, "s",
        "time for which the last belief of the external localization moves with the odometry if no belief can be "
        "read; then the robot continues with its own localization");
}

/// Whether the external localization is in use; passed from frame to frame.
struct ExternalUse {
  bool in_use = false;      ///< the previous frame used the external belief
  double unread_for = 0.0;  ///< s without a readable belief since then
};
template <typename Visit, ConstOr<ExternalUse> T>
void fields(Visit&& visit, T& use) {
  visit(use.in_use, use.unread_for);
}

class ExternalBeliefReader {
 public:
  explicit ExternalBeliefReader(const FieldDimensions& field);

  /// `last`: the previous belief; among several clusters of particles its cluster is preferred, as in the pose filter.
  /// Nothing: no belief, or one with values that are not finite or negative.
  std::optional<PoseBelief> read(const std::optional<ExternalBelief>& external, const PoseBelief& last,
                                 const PoseClusterParameters& parameters);

  /// Particles of the last belief, or its pose if it has no particles. Empty: it could not be read.
  const std::vector<Pose2>& poses() const { return poses_; }

 private:
  bool take_particles(std::span<const ExternalBelief::Particle> particles);

  Eigen::Vector2d half_size_;
  PoseClusters clusters_;
  ParticleSet particles_;
  std::vector<Pose2> poses_;
};

/// Whether the belief is certain enough to act on: direction and approximate position.
bool is_known(const PoseBelief& belief);

/// The expected belief after a reorientation.
PoseBelief expected_after(Reorientation reorientation, const PoseBelief& belief);

}  // namespace reorient
