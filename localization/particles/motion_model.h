// SPDX-License-Identifier: MIT
// How pose particles follow the odometry, and how much they spread.
#pragma once

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/particles/particle_set.h"

namespace reorient {

/// Noise grows with the square root of time, distance and rotation, so that it does not depend on the frame rate.
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
        "standard deviation of the position along each axis per root of time, also while the robot stands");
  visit("position_noise_per_distance", p.position_noise_per_distance, 0.0, 1.0, "m/m^0.5",
        "standard deviation of the position along each axis per root of the distance walked");
  visit("rotation_noise_per_time", p.rotation_noise_per_time, 0.0, 1.0, "rad/s^0.5",
        "standard deviation of the rotation per root of time, also while the robot stands");
  visit("rotation_noise_per_distance", p.rotation_noise_per_distance, 0.0, 1.0, "rad/m^0.5",
        "standard deviation of the rotation per root of the distance walked");
  visit("rotation_noise_per_rotation", p.rotation_noise_per_rotation, 0.0, 1.0, "rad/rad^0.5",
        "standard deviation of the rotation per root of the angle turned");
}

/// The step, or no motion if it is not finite or longer than 10 m, which means that the odometry is broken.
Pose2 believable_step(const Pose2& odometry_step);

/// Standard deviations of one step.
struct StepNoise {
  double position = 0.0;  ///< m, along each axis
  double rotation = 0.0;  ///< rad
};
/// `time`: s, non-negative.
StepNoise step_noise(const Pose2& step, double time, const MotionModelParameters& parameters);

/// Moves each particle by believable_step(`odometry_step`) and by its own random noise. `odometry_step`: the robot's
/// motion since the last call, in its frame at that time. `time_step`: s. `half_size` (m) limits the positions.
void predict(ParticleSet& particles, const Pose2& odometry_step, double time_step,
             const MotionModelParameters& parameters, const Eigen::Vector2d& half_size, Random& random);

}  // namespace reorient
