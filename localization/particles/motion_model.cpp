// SPDX-License-Identifier: MIT
#include "localization/particles/motion_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/square.h"

namespace reorient {
namespace {

/// Roughly normal noise for the three coordinates of a particle, from one random number: sums of three, three and two
/// of its bytes. The noise of one frame is small, and many frames add up to a normal distribution.
struct RoughNoise {
  std::int32_t ahead, aside, turned;
};

// Mean and standard deviation of such sums; the variance of a byte is (256^2 - 1) / 12.
constexpr float kMeanOfThree = 382.5f, kMeanOfTwo = 255.0f;
constexpr double kDeviationOfThree = 127.999, kDeviationOfTwo = 104.511;

RoughNoise rough_noise(Random& random) {
  constexpr std::uint64_t kEverySecondByte = 0x00FF00FF00FF00FFull;
  const std::uint64_t bits = random();
  const std::uint64_t pairs = (bits & kEverySecondByte) + ((bits >> 8) & kEverySecondByte);
  return {static_cast<std::int32_t>((pairs & 0xFFFF) + ((bits >> 16) & 0xFF)),
          static_cast<std::int32_t>(((pairs >> 32) & 0xFFFF) + ((bits >> 24) & 0xFF)),
          static_cast<std::int32_t>(pairs >> 48)};
}

}  // namespace

StepNoise step_noise(const Pose2& step, double time, const MotionModelParameters& p) {
  const double distance = step.position.norm();
  const double turn = std::abs(step.rotation);
  return {std::sqrt(square(p.position_noise_per_time) * time + square(p.position_noise_per_distance) * distance),
          std::sqrt(square(p.rotation_noise_per_time) * time + square(p.rotation_noise_per_distance) * distance +
                    square(p.rotation_noise_per_rotation) * turn)};
}

Pose2 believable_step(const Pose2& odometry_step) {
  constexpr double kLongest = 10.0;  // m
  // False if a value is NaN.
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
  const auto position_noise = static_cast<float>(noise.position / kDeviationOfThree);
  // An eighth of a turn at most: 3.5 deviations must stay below half a turn to fit into the integer.
  const auto rotation_noise =
      static_cast<float>(std::min(noise.rotation, kPi / 4.0) * kBinaryAnglesPerRadian / kDeviationOfTwo);
  const BinaryAngle turn = to_binary_angle(step.rotation);
  const auto limit_x = static_cast<float>(half_size.x());
  const auto limit_y = static_cast<float>(half_size.y());

  // In blocks: first the random numbers, one after the other, then the arithmetic, which the compiler vectorizes.
  std::array<std::int32_t, 64> ahead, aside, turned;
  for (std::size_t begin = 0; begin < particles.size(); begin += ahead.size()) {
    const std::size_t count = std::min(ahead.size(), particles.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const RoughNoise noise_of_one = rough_noise(random);
      ahead[i] = noise_of_one.ahead;
      aside[i] = noise_of_one.aside;
      turned[i] = noise_of_one.turned;
    }
    float* const particle_x = particles.x.data() + begin;
    float* const particle_y = particles.y.data() + begin;
    BinaryAngle* const rotation = particles.rotation.data() + begin;
    float* const cosines = particles.cosine.data() + begin;
    float* const sines = particles.sine.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
      const float to_front = forward + position_noise * (static_cast<float>(ahead[i]) - kMeanOfThree);
      const float to_left = left + position_noise * (static_cast<float>(aside[i]) - kMeanOfThree);
      const float x = particle_x[i] + cosines[i] * to_front - sines[i] * to_left;
      const float y = particle_y[i] + sines[i] * to_front + cosines[i] * to_left;
      particle_x[i] = std::clamp(x, -limit_x, limit_x);
      particle_y[i] = std::clamp(y, -limit_y, limit_y);
      rotation[i] += turn + static_cast<BinaryAngle>(static_cast<std::int32_t>(
                                rotation_noise * (static_cast<float>(turned[i]) - kMeanOfTwo)));
    }
  }
  for (std::size_t i = 0; i < particles.size(); ++i) particles.cosine[i] = cosine(particles.rotation[i]);
  for (std::size_t i = 0; i < particles.size(); ++i) particles.sine[i] = sine(particles.rotation[i]);
}

}  // namespace reorient
