// SPDX-License-Identifier: MIT
#include "localization/reorientation.h"

#include <array>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/localization/arbitrary_particles.h"

namespace reorient {
namespace {

double radian_as_meter(const Pose2& a, const Pose2& b) {
  return std::hypot((a.position - b.position).norm(), angle_difference(a.rotation, b.rotation));
}

RC_GTEST_PROP(FlipPose, TwiceIsExactlyTheIdentity, ()) {
  const ParticleSet before = any_particles();
  ParticleSet particles = before;
  flip_pose(particles);
  flip_pose(particles);
  RC_ASSERT(same(particles, before));
}

RC_GTEST_PROP(FlipPose, ReflectsEveryParticleAndLeavesItsWeight, ()) {
  const ParticleSet before = any_particles();
  ParticleSet particles = before;
  flip_pose(particles);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    RC_ASSERT(radian_as_meter(particles.pose(i), reflect(before.pose(i))) < 1e-8);
    RC_ASSERT(particles.cosine[i] == cosine(particles.rotation[i]));
    RC_ASSERT(particles.sine[i] == sine(particles.rotation[i]));
  }
  RC_ASSERT(particles.weight == before.weight);
}

RC_GTEST_PROP(PurgeReflection, LeavesOnlyCopiesOfParticlesNearerToTheBelief, ()) {
  const ParticleSet before = any_particles();
  const Pose2 belief = before.pose(0);
  ParticleSet particles = before;
  ParticleSet scratch(before.size());
  Random random(1);
  purge_reflection(particles, belief, scratch, random);
  RC_ASSERT(particles.size() == before.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Pose2 pose = particles.pose(i);
    RC_ASSERT(radian_as_meter(pose, belief) <= radian_as_meter(pose, reflect(belief)) + 1e-6);
    RC_ASSERT(std::find(before.rotation.begin(), before.rotation.end(), particles.rotation[i]) !=
              before.rotation.end());
  }
}

RC_GTEST_PROP(PurgeReflection, ChangesNothingTheSecondTime, ()) {
  ParticleSet particles = any_particles();
  const Pose2 belief = particles.pose(0);
  ParticleSet scratch(particles.size());
  Random random(1);
  purge_reflection(particles, belief, scratch, random);
  const ParticleSet once = particles;
  purge_reflection(particles, belief, scratch, random);
  RC_ASSERT(same(particles, once));
}

TEST(PurgeReflection, DecidesByTheRotationAtTheCenterOfTheField) {
  ParticleSet particles(10);
  for (std::size_t i = 0; i < 10; ++i) particles.set_pose(i, {0.0, 0.0, i < 3 ? 0.1 : kPi});
  ParticleSet scratch(10);
  Random random(1);
  purge_reflection(particles, Pose2(), scratch, random);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(particles.pose(i).rotation, 0.1, 1e-6);
}

TEST(PurgeReflection, KeepsAllParticlesWhenNoneWouldRemain) {
  ParticleSet particles(10);
  for (std::size_t i = 0; i < 10; ++i) particles.set_pose(i, {2.0, 0.0, kPi});
  const ParticleSet before = particles;
  ParticleSet scratch(10);
  Random random(1);
  purge_reflection(particles, {-2.0, 0.0, 0.0}, scratch, random);
  EXPECT_TRUE(same(particles, before));
}

RC_GTEST_PROP(ResetOrientation, DoesNotChangePositionsAndWeights, ()) {
  const ParticleSet before = any_particles();
  ParticleSet particles = before;
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  reset_orientation(particles, random);
  RC_ASSERT(particles.x == before.x);
  RC_ASSERT(particles.y == before.y);
  RC_ASSERT(particles.weight == before.weight);
}

TEST(ResetOrientation, SpreadsTheRotationsOverTheFullTurn) {
  ParticleSet particles(200);
  Random random(1);
  reset_orientation(particles, random);
  std::array<int, 20> counts{};
  for (const BinaryAngle angle : particles.rotation)
    ++counts[static_cast<std::size_t>(angle / (1.0 + 0xFFFFFFFFu) * 20.0)];
  for (const int count : counts) EXPECT_NEAR(count, 10, 3);
}

TEST(ResetOrientation, GivesEachRotationTheSameChance) {
  Random random(1);
  ParticleSet particles(1);
  int behind = 0;
  for (int i = 0; i < 1000; ++i) {
    reset_orientation(particles, random);
    if (std::abs(particles.pose(0).rotation) > kPi / 2.0) ++behind;
  }
  EXPECT_NEAR(behind, 500, 60);
}

}  // namespace
}  // namespace reorient
