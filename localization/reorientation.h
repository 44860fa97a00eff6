// SPDX-License-Identifier: MIT
// The three commands with which behaviours rearrange the pose particles (the paper's Section 3.1).
#pragma once

#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/particles/particle_set.h"
#include "localization/pose_belief.h"

namespace reorient {

/// Reflects every particle, of whatever cluster: what was believed becomes its reflection, and what was doubted as the
/// reflection becomes what is believed. So nothing is lost, and a flip done twice changes nothing.
void flip_pose(ParticleSet& particles);

/// The belief of the flipped particles.
PoseBelief flipped(const PoseBelief& belief);

/// Removes all particles that are nearer to the reflection of `belief` than to `belief`, and fills their places with
/// copies of the others. A metre counts as much as a radian, so that at the centre of the field the rotation decides.
/// Where no particle would be left, all stay. `scratch` is working memory of the same size.
void purge_reflection(ParticleSet& particles, const Pose2& belief, ParticleSet& scratch, Random& random);

/// Leaves all positions as they are and spreads the rotations evenly over the full turn.
void reset_orientation(ParticleSet& particles, Random& random);

}  // namespace reorient
