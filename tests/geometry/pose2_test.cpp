// SPDX-License-Identifier: MIT
#include "geometry/pose2.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

Pose2 any_pose() {
  const auto meters = [] { return *rc::gen::inRange(-8000, 8000) * 1e-3; };
  const double x = meters();
  const double y = meters();
  return {x, y, *rc::gen::inRange(-7000, 7000) * 1e-3};
}

double distance(const Pose2& a, const Pose2& b) {
  return (a.position - b.position).norm() + std::abs(angle_difference(a.rotation, b.rotation));
}

TEST(Pose2, MapsAPointAheadOfARobotThatLooksLeft) {
  const Eigen::Vector2d point = Pose2(1.0, 2.0, kPi / 2.0) * Eigen::Vector2d(3.0, 0.0);
  EXPECT_NEAR(point.x(), 1.0, 1e-12);
  EXPECT_NEAR(point.y(), 5.0, 1e-12);
}

TEST(Pose2, ReflectionOfTheStartPositionIsThatOfTheOtherTeam) {
  const Pose2 reflected = reflect(Pose2(-3.2, 3.5, from_degrees(-90.0)));
  EXPECT_NEAR(reflected.position.x(), 3.2, 1e-12);
  EXPECT_NEAR(reflected.position.y(), -3.5, 1e-12);
  EXPECT_NEAR(reflected.rotation, from_degrees(90.0), 1e-12);
}

RC_GTEST_PROP(Pose2, ReflectedTwiceIsItself, ()) {
  const Pose2 pose = any_pose();
  RC_ASSERT(distance(reflect(reflect(pose)), pose) < 1e-9);
}

RC_GTEST_PROP(Pose2, TimesItsInverseIsTheIdentity, ()) {
  const Pose2 pose = any_pose();
  RC_ASSERT(distance(pose * pose.inverse(), Pose2()) < 1e-9);
  RC_ASSERT(distance(pose.inverse() * pose, Pose2()) < 1e-9);
}

RC_GTEST_PROP(Pose2, AgreesWithTheSameMotionInSpace, ()) {
  const Pose2 a = any_pose();
  const Pose2 b = any_pose();
  const Isometry3 product = to_isometry(a) * to_isometry(b);
  RC_ASSERT(product.isApprox(to_isometry(a * b), 1e-9));
}

}  // namespace
}  // namespace reorient
