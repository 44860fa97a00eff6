// SPDX-License-Identifier: MIT
#include "localization/particles/motion_model.h"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localization/measurement/field_map.h"
#include "tests/localization/arbitrary_particles.h"

namespace reorient {
namespace {

const MotionModelParameters kNoNoise{0.0, 0.0, 0.0, 0.0, 0.0};
const Eigen::Vector2d kHalfSize = believable_half_size(FieldDimensions());

struct Spread {
  double x = 0.0;         ///< m
  double rotation = 0.0;  ///< rad
};

/// Standard deviations after one second with this motion, in equal steps.
Spread spread_after_a_second(const Pose2& motion, int steps) {
  ParticleSet particles(4000);
  Random random(3);
  for (int i = 0; i < steps; ++i) {
    predict(particles, {motion.position / steps, motion.rotation / steps}, 1.0 / steps, MotionModelParameters(),
            kHalfSize, random);
  }
  double x = 0.0;
  double square_x = 0.0;
  double square_rotation = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    x += particles.pose(i).position.x() / 4000.0;
    square_x += std::pow(particles.pose(i).position.x(), 2) / 4000.0;
    square_rotation += std::pow(angle_difference(particles.pose(i).rotation, motion.rotation), 2) / 4000.0;
  }
  return {std::sqrt(square_x - x * x), std::sqrt(square_rotation)};
}

RC_GTEST_PROP(MotionModel, WithoutNoiseMovesEachParticleByTheOdometryStep, ()) {
  const Pose2 pose = any_pose_on_carpet();
  const Pose2 step(*rc::gen::inRange(-900, 900) * 1e-3, *rc::gen::inRange(-900, 900) * 1e-3,
                   *rc::gen::inRange(-3000, 3000) * 1e-3);
  ParticleSet particles(2);
  particles.set_pose(1, pose);
  Random random(1);
  predict(particles, step, 0.1, kNoNoise, kHalfSize, random);
  const Pose2 expected = pose * step;
  const Eigen::Vector2d limited = expected.position.cwiseMax(-kHalfSize).cwiseMin(kHalfSize);
  RC_ASSERT((particles.pose(1).position - limited).norm() < 1e-5);
  RC_ASSERT(std::abs(angle_difference(particles.pose(1).rotation, expected.rotation)) < 1e-6);
  RC_ASSERT(std::abs(static_cast<double>(particles.sine[1]) - std::sin(expected.rotation)) < 1e-6);
}

TEST(MotionModel, SpreadsByDistanceAndRotationIndependentOfTheFrameRate) {
  const MotionModelParameters p;
  for (const int steps : {10, 100}) {
    const Spread standing = spread_after_a_second(Pose2(), steps);
    EXPECT_NEAR(standing.x, p.position_noise_per_time, 0.1 * p.position_noise_per_time);
    EXPECT_NEAR(standing.rotation, p.rotation_noise_per_time, 0.1 * p.rotation_noise_per_time);
    const Spread walking = spread_after_a_second({0.3, 0.0, 0.0}, steps);
    EXPECT_NEAR(walking.x, std::hypot(p.position_noise_per_time, p.position_noise_per_distance * std::sqrt(0.3)), 0.01);
    const Spread turning = spread_after_a_second({0.0, 0.0, 1.0}, steps);
    EXPECT_NEAR(turning.rotation, std::hypot(p.rotation_noise_per_time, p.rotation_noise_per_rotation), 0.02);
  }
}

TEST(MotionModel, KeepsParticlesWithinAMeterOfTheCarpet) {
  ParticleSet particles(100);
  Random random(1);
  predict(particles, {7.0, -7.0, 0.0}, 1.0, MotionModelParameters(), kHalfSize, random);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    EXPECT_LE(std::abs(particles.x[i]), 6.2f);
    EXPECT_LE(std::abs(particles.y[i]), 4.7f);
  }
}

TEST(MotionModel, IgnoresAStepThatIsNotFiniteOrImpossiblyLong) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Pose2& step : {Pose2(kNaN, 0.0, 0.0), Pose2(0.0, infinity, 0.0), Pose2(0.0, 0.0, kNaN),
                            Pose2(1e300, 0.0, 0.0), Pose2(0.0, -11.0, 0.0)}) {
    ParticleSet particles(10);
    Random random(1);
    predict(particles, step, kNaN, MotionModelParameters(), kHalfSize, random);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      EXPECT_EQ(particles.pose(i).position, Eigen::Vector2d::Zero().eval());
      EXPECT_EQ(particles.rotation[i], 0u);
    }
  }
}

}  // namespace
}  // namespace reorient
