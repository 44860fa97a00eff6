// SPDX-License-Identifier: MIT
#include "localization/particles/pose_clusters.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "localization/reorientation.h"
#include "tests/localization/arbitrary_particles.h"

namespace reorient {
namespace {

/// `count` particles: the first `first` ones around `a`, the others around `b`.
ParticleSet two_clusters(const Pose2& a, const Pose2& b, std::size_t first, std::size_t count) {
  ParticleSet particles(count);
  Random random(5);
  for (std::size_t i = 0; i < count; ++i) {
    const Pose2& center = i < first ? a : b;
    particles.set_pose(i, center * Pose2(0.1 * random.normal(), 0.1 * random.normal(), 0.05 * random.normal()));
  }
  return particles;
}

PoseBelief believed(const Pose2& pose) {
  PoseBelief belief;
  belief.pose = pose;
  return belief;
}

bool is_near(const Pose2& a, const Pose2& b) {
  return (a.position - b.position).norm() < 0.1 && std::abs(angle_difference(a.rotation, b.rotation)) < 0.1;
}

RC_GTEST_PROP(PoseClusters, FindsTheHeavierOfTwoFromAnywhere, ()) {
  const Pose2 pose = any_pose_on_carpet();
  RC_PRE(pose.position.norm() > 1.0);
  PoseClusters clusters{FieldDimensions()};
  const PoseBelief belief = clusters.find(two_clusters(pose, reflect(pose), 150, 200), PoseBelief(), {});
  RC_ASSERT(is_near(belief.pose, pose));
  RC_ASSERT(std::abs(belief.cluster_weight - 0.75) < 0.01);
  RC_ASSERT(std::abs(belief.reflected_weight - 0.25) < 0.01);
}

TEST(PoseClusters, StaysWithTheLighterOfTwoUntilTheOtherClearlyLeads) {
  const Pose2 pose(-2.0, 1.0, 0.3);
  PoseClusters clusters{FieldDimensions()};
  EXPECT_TRUE(is_near(clusters.find(two_clusters(pose, reflect(pose), 85, 200), believed(pose), {}).pose, pose));
  EXPECT_TRUE(
      is_near(clusters.find(two_clusters(pose, reflect(pose), 70, 200), believed(pose), {}).pose, reflect(pose)));
}

TEST(PoseClusters, SeparatesTwoRotationsAtOnePosition) {
  const Pose2 pose(0.0, 0.0, 0.0);
  PoseClusters clusters{FieldDimensions()};
  const PoseBelief belief = clusters.find(two_clusters(pose, reflect(pose), 60, 200), believed(pose), {});
  EXPECT_TRUE(is_near(belief.pose, reflect(pose)));
  EXPECT_NEAR(belief.cluster_weight, 0.7, 0.01);
}

TEST(PoseClusters, MeasuresTheSpreadOfItsParticles) {
  const Pose2 pose(1.0, 2.0, kPi);
  PoseClusters clusters{FieldDimensions()};
  const PoseBelief belief = clusters.find(two_clusters(pose, pose, 2000, 2000), believed(pose), {});
  EXPECT_NEAR(std::sqrt(belief.covariance(0, 0)), 0.1, 0.01);
  EXPECT_NEAR(std::sqrt(belief.covariance(1, 1)), 0.1, 0.01);
  EXPECT_NEAR(std::sqrt(belief.covariance(2, 2)), 0.05, 0.005);
}

TEST(PoseClusters, CountsWeightsInsteadOfParticles) {
  const Pose2 pose(-2.0, 1.0, 0.3);
  ParticleSet particles = two_clusters(pose, reflect(pose), 20, 200);
  for (std::size_t i = 0; i < 20; ++i) particles.weight[i] *= 81.0f;
  normalize_weights(particles);
  PoseClusters clusters{FieldDimensions()};
  const PoseBelief belief = clusters.find(particles, PoseBelief(), {});
  EXPECT_TRUE(is_near(belief.pose, pose));
  EXPECT_NEAR(belief.cluster_weight, 0.9, 0.01);
}

RC_GTEST_PROP(PoseClusters, FindsAFiniteBeliefInAnyParticles, ()) {
  PoseClusters clusters{FieldDimensions()};
  const PoseBelief belief = clusters.find(any_particles(), believed(any_pose_on_carpet()), {});
  RC_ASSERT(belief.pose.position.allFinite());
  RC_ASSERT(belief.covariance.allFinite());
  RC_ASSERT(belief.cluster_weight > 0.0 && belief.cluster_weight < 1.0001);
  RC_ASSERT(belief.reflected_weight >= 0.0 && belief.reflected_weight <= 1.0);
}

}  // namespace
}  // namespace reorient
