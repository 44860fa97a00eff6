// SPDX-License-Identifier: MIT
// How pose particles follow the odometry, and how much they spread on the way.
#pragma once

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/particles/particle_set.h"

namespace reorient {

/// Noise grows with the root of time, of way and of turn, so that it does not depend on the frame rate.
struct MotionModelParameters {
  double position_noise_per_time = 0.02;
  double position_noise_per_distance = 0.12;
  double rotation_noise_per_time = 0.03;
  double rotation_noise_per_distance = 0.08;
  double rotation_noise_per_rotation = 0.15;
};

template <typename Visit>
void describe(MotionModelParameters& p, Visit&& visit) {
  visit("position_noise_per_time", p.position_noise_per_time, 0.0, 1.0, "m/s^0.5",
        "how far a standing robot's position spreads");
  visit("position_noise_per_distance", p.position_noise_per_distance, 0.0, 1.0, "m/m^0.5",
        "how far the position spreads with the way walked");
  visit("rotation_noise_per_time", p.rotation_noise_per_time, 0.0, 1.0, "rad/s^0.5",
        "how far a standing robot's rotation spreads");
  visit("rotation_noise_per_distance", p.rotation_noise_per_distance, 0.0, 1.0, "rad/m^0.5",
        "how far the rotation spreads with the way walked");
  visit("rotation_noise_per_rotation", p.rotation_noise_per_rotation, 0.0, 1.0, "rad/rad^0.5",
        "how far the rotation spreads with the turn made");
}

/// The step itself, or none where it is not finite or longer than any robot's (10 m): then the odometry is broken.
Pose2 believable_step(const Pose2& odometry_step);

/// Standard deviations of one step.
struct StepNoise {
  double position = 0.0;  ///< m, along each axis
  double rotation = 0.0;  ///< rad
};
/// `time`: s, not negative.
StepNoise step_noise(const Pose2& step, double time, const MotionModelParameters& parameters);

/// Moves every particle by `odometry_step` (the robot's motion since the last call, in its own frame then), as far as
/// it is believable, and by noise of its own; `time_step` in seconds. Particles stay within `half_size` of the centre.
void predict(ParticleSet& particles, const Pose2& odometry_step, double time_step,
             const MotionModelParameters& parameters, const Eigen::Vector2d& half_size, Random& random);

}  // namespace reorient
