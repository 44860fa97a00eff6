// SPDX-License-Identifier: MIT
// The three commands with which behaviors change the pose particles (the paper's Section 3.1).
#pragma once

#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/particles/particle_set.h"
#include "localization/pose_belief.h"

namespace reorient {

/// Replaces each particle, of every cluster, with its reflection. So no hypothesis is lost, and a second flip restores
/// the particles.
void flip_pose(ParticleSet& particles);

/// The belief of the flipped particles.
PoseBelief flipped(const PoseBelief& belief);

/// Replaces all particles that are nearer to the reflection of `belief` than to `belief` with copies of the others. One
/// meter counts as much as one radian, so that the rotation decides at the center of the field. If no particle would
/// remain, all stay. `scratch` is working memory of the same size.
void purge_reflection(ParticleSet& particles, const Pose2& belief, ParticleSet& scratch, Random& random);

/// Leaves all positions unchanged and distributes the rotations evenly over the full circle.
void reset_orientation(ParticleSet& particles, Random& random);

}  // namespace reorient
