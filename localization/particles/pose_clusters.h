// SPDX-License-Identifier: MIT
// Computes the believed pose from the pose particles: the mean of the heaviest cluster.
#pragma once

#include <vector>

#include "geometry/field_dimensions.h"
#include "localization/particles/particle_set.h"
#include "localization/pose_belief.h"

namespace reorient {

struct PoseClusterParameters {
  double radius = 0.75;
  double max_rotation_difference = 0.7;
  double lead_to_switch = 1.5;
};

template <typename Visit>
void describe(PoseClusterParameters& p, Visit&& visit) {
  visit("radius", p.radius, 0.1, 3.0, "m", "largest distance of a cluster's particles from its mean");
  visit("max_rotation_difference", p.max_rotation_difference, 0.1, 3.0, "rad",
        "largest difference between the rotations of a cluster's particles and of its mean");
  visit("lead_to_switch", p.lead_to_switch, 1.0, 10.0, "",
        "ratio of another cluster's weight to the believed one's at which that cluster becomes the belief");
}

/// Finds clusters by counting in overlapping bins and shifting the mean of the fullest (Fukunaga and Hostetler, 1975).
class PoseClusters {
 public:
  explicit PoseClusters(const FieldDimensions& field);

  /// The new belief. `last`: the previous one, with its pose moved by the odometry. Its cluster remains the belief
  /// until another one is clearly heavier, so that the belief does not jump between clusters of equal weight.
  PoseBelief find(const ParticleSet& particles, const PoseBelief& last, const PoseClusterParameters& parameters);

 private:
  Pose2 center_of_fullest_bin(const ParticleSet& particles);

  double half_length_ = 0.0;  ///< m, of the area that the bins cover
  double half_width_ = 0.0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> bins_;  ///< weight in [rotation][row][column]
};

/// Fraction of the particles' weight in a cluster with this mean.
double weight_near(const ParticleSet& particles, const Pose2& mean, const PoseClusterParameters& parameters);

}  // namespace reorient
