#include "localization/particles/motion_model.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

/// Standard deviations of one step.
struct StepNoise {
  double position = 0.0;  ///< m, along each axis
  double rotation = 0.0;  ///< rad
};

StepNoise step_noise(const Pose2& step, double time, const MotionModelParameters& p) {
  const double way = step.position.norm();
  const double turn = std::abs(step.rotation);
  const auto square = [](double value) { return value * value; };
  return {std::sqrt(square(p.position_noise_per_time) * time + square(p.position_noise_per_distance) * way),
          std::sqrt(square(p.rotation_noise_per_time) * time + square(p.rotation_noise_per_distance) * way +
                    square(p.rotation_noise_per_rotation) * turn)};
}

}  // namespace

Pose2 believable_step(const Pose2& odometry_step) {
  constexpr double kLongest = 10.0;  // m
  // False where either is not a number.
  const bool believable = odometry_step.position.norm() <= kLongest && std::abs(odometry_step.rotation) <= kPi;
  return believable ? odometry_step : Pose2();
}

void predict(ParticleSet& particles, const Pose2& odometry_step, double time_step,
             const MotionModelParameters& parameters, const Eigen::Vector2d& half_size, Random& random) {
  const Pose2 step = believable_step(odometry_step);
  const double time = std::isfinite(time_step) ? std::clamp(time_step, 0.0, 1.0) : 0.0;
  const StepNoise noise = step_noise(step, time, parameters);

  const auto forward = static_cast<float>(step.position.x());
  const auto left = static_cast<float>(step.position.y());
  const auto position_noise = static_cast<float>(noise.position);
  const auto rotation_noise = static_cast<float>(noise.rotation * kBinaryAnglesPerRadian);
  const BinaryAngle turn = to_binary_angle(step.rotation);
  const auto limit_x = static_cast<float>(half_size.x());
  const auto limit_y = static_cast<float>(half_size.y());

  for (std::size_t i = 0; i < particles.size(); ++i) {
    const float ahead = forward + position_noise * rough_normal(random);
    const float aside = left + position_noise * rough_normal(random);
    const float x = particles.x[i] + particles.cosine[i] * ahead - particles.sine[i] * aside;
    const float y = particles.y[i] + particles.sine[i] * ahead + particles.cosine[i] * aside;
    particles.x[i] = std::clamp(x, -limit_x, limit_x);
    particles.y[i] = std::clamp(y, -limit_y, limit_y);
    // By way of 64 bits: any float of up to a few turns fits, and the rest wraps.
    particles.rotation[i] +=
        turn + static_cast<BinaryAngle>(static_cast<std::int64_t>(rotation_noise * rough_normal(random)));
  }
  for (std::size_t i = 0; i < particles.size(); ++i) particles.cosine[i] = cosine(particles.rotation[i]);
  for (std::size_t i = 0; i < particles.size(); ++i) particles.sine[i] = sine(particles.rotation[i]);
}

}  // namespace reorient
