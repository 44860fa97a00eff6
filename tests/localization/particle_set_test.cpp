// SPDX-License-Identifier: MIT
#include "localization/particles/particle_set.h"

#include <limits>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/localization/arbitrary_particles.h"

namespace reorient {
namespace {

double sum_of_weights(const ParticleSet& particles) {
  return std::accumulate(particles.weight.begin(), particles.weight.end(), 0.0);
}

double weighted_x(const ParticleSet& particles) {
  return std::inner_product(particles.x.begin(), particles.x.end(), particles.weight.begin(), 0.0);
}

RC_GTEST_PROP(ParticleSet, StoresAPose, ()) {
  const Pose2 pose = any_pose_on_carpet();
  ParticleSet particles(3);
  particles.set_pose(1, pose);
  RC_ASSERT((particles.pose(1).position - pose.position).norm() < 1e-5);
  RC_ASSERT(std::abs(angle_difference(particles.pose(1).rotation, pose.rotation)) < 1e-8);
  RC_ASSERT(std::abs(static_cast<double>(particles.cosine[1]) - std::cos(pose.rotation)) < 1e-6);
}

RC_GTEST_PROP(ParticleSet, HasWeightsWithTheSumOneAfterNormalization, ()) {
  ParticleSet particles = any_particles();
  for (float& weight : particles.weight) weight *= 1e-20f;
  normalize_weights(particles);
  RC_ASSERT(std::abs(sum_of_weights(particles) - 1.0) < 1e-4);
}

TEST(ParticleSet, FallsBackToEqualWeightsWhenTheWeightsAreInvalid) {
  for (const float useless : {0.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    ParticleSet particles(4);
    particles.weight.assign(4, useless);
    normalize_weights(particles);
    EXPECT_EQ(particles.weight, std::vector<float>(4, 0.25f));
  }
}

TEST(ParticleSet, HasAsManyEffectiveSamplesAsParticlesOfEqualWeight) {
  ParticleSet particles(8);
  EXPECT_NEAR(effective_sample_size(particles), 8.0, 1e-6);
  particles.weight.assign(8, 0.0f);
  particles.weight[3] = 1.0f;
  EXPECT_NEAR(effective_sample_size(particles), 1.0, 1e-6);
}

RC_GTEST_PROP(ParticleSet, ResamplingCopiesEachParticleInProportionToItsWeightWithinOne, ()) {
  const ParticleSet from = any_particles();
  ParticleSet to(static_cast<std::size_t>(*rc::gen::inRange(1, 100)));
  resample_systematic(from, to, *rc::gen::inRange(0, 1000) * 1e-3);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto copies = static_cast<double>(std::count(to.rotation.begin(), to.rotation.end(), from.rotation[i]));
    RC_ASSERT(std::abs(copies - static_cast<double>(from.weight[i]) * static_cast<double>(to.size())) < 1.001);
  }
  RC_ASSERT(std::abs(sum_of_weights(to) - 1.0) < 1e-4);
}

RC_GTEST_PROP(ParticleSet, ResamplingKeepsTheMeanOnAverage, ()) {
  const ParticleSet from = any_particles();
  ParticleSet to(from.size());
  constexpr int kOffsets = 1000;
  double mean = 0.0;
  for (int i = 0; i < kOffsets; ++i) {
    resample_systematic(from, to, (i + 0.5) / kOffsets);
    mean += weighted_x(to) / kOffsets;
  }
  RC_ASSERT(std::abs(mean - weighted_x(from)) < 0.01);
}

TEST(ParticleSet, ResamplingNeverCopiesAParticleWithoutWeight) {
  ParticleSet from(5);
  for (std::size_t i = 0; i < 5; ++i) from.set_pose(i, {static_cast<double>(i), 0.0, 0.0});
  from.weight = {0.0f, 0.4999f, 0.0f, 0.4999f, 0.0f};  // a sum slightly below 1, as after rounding
  ParticleSet to(100);
  resample_systematic(from, to, 0.9999);
  for (const float x : to.x) EXPECT_TRUE(x == 1.0f || x == 3.0f) << x;
}

TEST(ParticleSet, RoughlyNormalNoiseHasMeanZeroAndDeviationOne) {
  Random random(7);
  constexpr int kDraws = 100000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = rough_normal(random);
    sum += value;
    squares += value * value;
    ASSERT_LT(std::abs(value), 3.5);
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.02);
}

}  // namespace
}  // namespace reorient
