// SPDX-License-Identifier: MIT
#include "robots/footage/transform_tree.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "robots/footage/footage.h"

namespace reorient {
namespace {

using Validity = TransformTree::Validity;

messages::Quaternion yaw(double angle) { return {0.0, 0.0, std::sin(0.5 * angle), std::cos(0.5 * angle)}; }

messages::Transform sample(const std::string& parent, const std::string& child, double seconds,
                           const Eigen::Vector3d& translation, const messages::Quaternion& rotation = {}) {
  return {{static_cast<messages::Time>(1e9 * seconds), parent}, child, {translation, rotation}};
}

messages::Time instant(double seconds) { return static_cast<messages::Time>(1e9 * seconds); }

void expect_near(const std::optional<Isometry3>& found, const Eigen::Vector3d& translation, double angle) {
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->translation().isApprox(translation, 1e-9)) << found->translation().transpose();
  EXPECT_TRUE(found->linear().isApprox(rotation_about_z(angle), 1e-9)) << found->linear();
}

TEST(TransformTree, ComposesMotionsAlongTheTree) {
  TransformTree tree;
  // The base is at (1, 2) in the field and faces along y. The camera is 0.1 m in front of it and 0.5 m above, and
  // points to the left.
  tree.add(sample("map", "odom", 1.0, {1.0, 0.0, 0.0}), Validity::limited);
  tree.add(sample("odom", "base", 1.0, {0.0, 2.0, 0.0}, yaw(kPi / 2.0)), Validity::limited);
  tree.add(sample("base", "camera", 0.0, {0.1, 0.0, 0.5}, yaw(kPi / 2.0)), Validity::fixed);
  tree.add(sample("base", "imu", 0.0, {0.0, 0.3, 0.0}), Validity::fixed);
  expect_near(tree.find("map", "base", instant(1.0), {}), {1.0, 2.0, 0.0}, kPi / 2.0);
  expect_near(tree.find("map", "camera", instant(1.0), {}), {1.0, 2.1, 0.5}, kPi);
  expect_near(tree.find("base", "map", instant(1.0), {}), {-2.0, 1.0, 0.0}, -kPi / 2.0);
  expect_near(tree.find("camera", "imu", instant(1.0), {}), {0.3, 0.1, -0.5}, -kPi / 2.0);
  expect_near(tree.find("/map", "/base", instant(1.0), {}), {1.0, 2.0, 0.0}, kPi / 2.0);
  expect_near(tree.find("nowhere", "nowhere", instant(1.0), {}), {0.0, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(tree.find("map", "nowhere", instant(1.0), {}));
  EXPECT_EQ(tree.names(), "'base', 'camera', 'imu', 'map', 'odom'");
}

TEST(TransformTree, InterpolatesBetweenTheNeighborsInTime) {
  TransformTree tree;
  tree.add(sample("odom", "base", 2.0, {2.0, 0.0, 0.0}, yaw(0.2)), Validity::limited);
  tree.add(sample("odom", "base", 1.0, {1.0, 0.0, 0.0}, yaw(0.0)), Validity::limited);  // out of order
  tree.add(sample("odom", "base", 1.5, {1.0, 1.0, 0.0}, yaw(0.1)), Validity::limited);
  expect_near(tree.find("odom", "base", instant(1.0), {}), {1.0, 0.0, 0.0}, 0.0);
  expect_near(tree.find("odom", "base", instant(1.25), {}), {1.0, 0.5, 0.0}, 0.05);
  expect_near(tree.find("odom", "base", instant(1.75), {}), {1.5, 0.5, 0.0}, 0.15);
}

TEST(TransformTree, InterpolatesAlongTheShorterRotation) {
  TransformTree tree;
  const messages::Quaternion half = yaw(0.4);
  tree.add(sample("odom", "base", 1.0, {0.0, 0.0, 0.0}), Validity::limited);
  tree.add(sample("odom", "base", 2.0, {0.0, 0.0, 0.0}, {-half.x, -half.y, -half.z, -half.w}), Validity::limited);
  expect_near(tree.find("odom", "base", instant(1.5), {}), {0.0, 0.0, 0.0}, 0.2);
}

TEST(TransformTree, UsesNoSampleThatIsTooOld) {
  const MotionLimits limits{1.0, 0.2};
  TransformTree tree;
  tree.add(sample("odom", "base", 1.0, {1.0, 0.0, 0.0}), Validity::limited);
  tree.add(sample("odom", "base", 5.0, {5.0, 0.0, 0.0}), Validity::limited);
  EXPECT_FALSE(tree.find("odom", "base", instant(0.7), limits));
  expect_near(tree.find("odom", "base", instant(0.9), limits), {1.0, 0.0, 0.0}, 0.0);
  expect_near(tree.find("odom", "base", instant(1.1), limits), {1.0, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(tree.find("odom", "base", instant(3.0), limits)) << "the gap is too long";
  expect_near(tree.find("odom", "base", instant(4.9), limits), {5.0, 0.0, 0.0}, 0.0);
  EXPECT_FALSE(tree.find("odom", "base", instant(5.3), limits));
}

TEST(TransformTree, OfFoxgloveIsValidUntilTheNextOne) {
  TransformTree tree;
  tree.add(sample("odom", "base", 1.0, {1.0, 0.0, 0.0}), Validity::lasting);
  tree.add(sample("odom", "base", 5.0, {5.0, 0.0, 0.0}), Validity::lasting);
  expect_near(tree.find("odom", "base", instant(0.0), {}), {1.0, 0.0, 0.0}, 0.0);
  expect_near(tree.find("odom", "base", instant(3.0), {}), {1.0, 0.0, 0.0}, 0.0);
  expect_near(tree.find("odom", "base", instant(100.0), {}), {5.0, 0.0, 0.0}, 0.0);
}

TEST(TransformTree, IgnoresTransformsThatAreNotRigid) {
  TransformTree tree;
  EXPECT_FALSE(tree.add(sample("a", "b", 1.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}), Validity::limited));
  EXPECT_FALSE(tree.add(sample("a", "b", 1.0, {NAN, 0.0, 0.0}), Validity::limited));
  EXPECT_FALSE(tree.add(sample("a", "a", 1.0, {0.0, 0.0, 0.0}), Validity::limited));
  EXPECT_FALSE(tree.add(sample("", "b", 1.0, {0.0, 0.0, 0.0}), Validity::limited));
  EXPECT_FALSE(tree.find("a", "b", instant(1.0), {}));
}

TEST(TransformTree, DoesNotHangAtACycle) {
  TransformTree tree;
  tree.add(sample("a", "b", 1.0, {1.0, 0.0, 0.0}), Validity::fixed);
  tree.add(sample("b", "a", 1.0, {1.0, 0.0, 0.0}), Validity::fixed);
  EXPECT_FALSE(tree.find("c", "a", instant(1.0), {}));
}

TEST(TransformTree, RefusesMoreFramesThanARobotHas) {
  TransformTree tree;
  const auto fill = [&] {
    for (int i = 0; i <= 10000; ++i)
      tree.add(sample("root", "frame" + std::to_string(i), 1.0, {0.0, 0.0, 0.0}), Validity::limited);
  };
  EXPECT_THROW(fill(), BadFootage);
}

RC_GTEST_PROP(TransformTree, FindsTheInverseInTheOtherDirection, ()) {
  const auto number = [] { return 0.001 * *rc::gen::inRange(-3000, 3000); };
  TransformTree tree;
  for (const auto& [parent, child] : {std::pair("a", "b"), std::pair("b", "c"), std::pair("a", "d")}) {
    const double x = number(), y = number(), angle = number();
    tree.add(sample(parent, child, 1.0, {x, y, 0.5}, yaw(angle)), Validity::limited);
  }
  const auto there = tree.find("c", "d", instant(1.0), {}), back = tree.find("d", "c", instant(1.0), {});
  RC_ASSERT(there && back);
  RC_ASSERT((*there * *back).matrix().isApprox(Eigen::Matrix4d::Identity(), 1e-9));
}

}  // namespace
}  // namespace reorient
