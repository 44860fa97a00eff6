// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/field_landmarks.h"
#include "tests/perception/field/stand.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

Stand at(const Pose2& pose, const HeadAngles& head = {0.0, 0.25}) { return {640, 480, pose, head}; }

/// The squared error, normalized by the covariance, must be possible for a covariance of two dimensions.
void expect_within(const Vector2d& error, const Eigen::Matrix2d& covariance) {
  EXPECT_LT(error.dot(covariance.inverse() * error), 9.2);  // 99 %
  EXPECT_GT(covariance.determinant(), 0.0);
}

TEST(Landmarks, OfAFieldAreReflectionsOfEachOther) {
  FieldDimensions field;
  field.corner_arc_radius = 0.5;
  const std::vector<FieldIntersection> all = field_intersections(field);
  EXPECT_EQ(all.size(), 2u + 2u + 4u + 4u * 4u + 8u);
  for (const FieldIntersection& one : all) {
    const auto twin = std::find_if(all.begin(), all.end(), [&](const FieldIntersection& other) {
      const double turned = angle_difference(one.direction + kPi, other.direction);
      const double quarter = one.kind == IntersectionKind::x ? std::remainder(turned, 0.5 * kPi) : turned;
      return one.kind == other.kind && (one.position + other.position).norm() < 1e-9 && std::abs(quarter) < 1e-9;
    });
    EXPECT_NE(twin, all.end()) << name_of(one.kind) << " at " << one.position.transpose();
  }
}

TEST(Landmarks, AreFewerOnAFieldWithoutAreasCircleAndArcs) {
  FieldDimensions field;
  field.penalty_area_depth = field.goal_area_depth = field.center_circle_radius = 0.0;
  EXPECT_EQ(field_intersections(field).size(), 2u + 4u);
  field.penalty_mark_size = 0.0;
  EXPECT_TRUE(penalty_marks(field).empty());
}

TEST(Landmarks, AreIntersectionsWithTheCorrectTypeAndPosition) {
  const FlatField scene;
  struct Case {
    const char* name;
    Pose2 pose;
    Vector2d place;
  };
  const Case cases[] = {{"corner of the field", {3.0, 1.6, 0.75}, {4.5, 3.0}},
                        {"corner of the penalty area", {1.2, 1.2, 0.5}, {2.85, 2.0}},
                        {"halfway line and touchline", {-0.3, 1.0, 1.4}, {0.0, 3.0}},
                        {"penalty area and goal line", {2.4, 2.4, -0.1}, {4.5, 2.0}},
                        {"circle and halfway line", {-1.3, -0.4, -0.1}, {0.0, -0.75}}};
  const std::vector<FieldIntersection> all = field_intersections(scene.field);
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    const Stand here = at(one.pose);
    const FieldPercept percept = percept_of(scene, here);
    const auto seen = std::find_if(
        percept.intersections.begin(), percept.intersections.end(),
        [&](const Intersection& it) { return (here.field_from_robot * it.position - one.place).norm() < 0.15; });
    ASSERT_NE(seen, percept.intersections.end());
    const auto real = std::find_if(
        all.begin(), all.end(), [&](const FieldIntersection& it) { return (it.position - one.place).norm() < 1e-9; });
    ASSERT_NE(real, all.end());
    EXPECT_EQ(seen->kind, real->kind) << name_of(seen->kind);
    const double turned = angle_difference(seen->direction + one.pose.rotation, real->direction);
    EXPECT_LT(std::abs(real->kind == IntersectionKind::x ? std::remainder(turned, 0.5 * kPi) : turned), 0.1);
    EXPECT_FALSE(seen->corner_arc);
    expect_within(here.field_from_robot * seen->position - one.place, seen->covariance);
  }
}

TEST(Landmarks, AreCornersOfTheFieldIfTheyHaveArcs) {
  FlatField scene;
  scene.field.corner_arc_radius = 0.5;
  const Stand here = at({2.9, 1.5, 0.8});
  const FieldPercept percept = percept_of(scene, here);
  int corners = 0;
  for (const Intersection& one : percept.intersections) {
    if (!one.corner_arc) continue;
    ++corners;
    EXPECT_EQ(one.kind, IntersectionKind::l);
    EXPECT_LT((here.field_from_robot * one.position - Vector2d(4.5, 3.0)).norm(), 0.1);
  }
  EXPECT_EQ(corners, 1);
  const Stand at_area = at({1.2, 1.2, 0.5});
  int of_area = 0;
  for (const Intersection& one : percept_of(scene, at_area).intersections) {
    if ((at_area.field_from_robot * one.position - Vector2d(2.85, 2.0)).norm() > 0.2) continue;
    ++of_area;
    EXPECT_FALSE(one.corner_arc);
  }
  EXPECT_EQ(of_area, 1);
}

TEST(Landmarks, IncludeNoIntersectionWhereALineEndsAtARobot) {
  FlatField scene;
  scene.field.center_circle_radius = 0.0;
  scene.boxes.push_back({{0.0, 0.9}, 0.35, 0.55, {200, 126, 130}});
  for (const Pose2& pose : {Pose2{-1.8, 0.6, 0.1}, Pose2{-1.5, 0.2, 0.3}})
    EXPECT_TRUE(percept_of(scene, at(pose)).intersections.empty());
}

TEST(Landmarks, IncludeTheCenterCircleAndItsHalfwayLine) {
  const FlatField scene;
  for (const Pose2& pose :
       {Pose2{-2.0, 0.0, 0.0}, Pose2{-1.5, 0.8, -0.4}, Pose2{1.6, -0.6, 2.7}, Pose2{0.2, -2.2, 1.5}}) {
    SCOPED_TRACE(testing::Message() << pose.position.transpose());
    const Stand here = at(pose);
    const FieldPercept percept = percept_of(scene, here);
    ASSERT_TRUE(percept.center_circle);
    const Vector2d center = here.field_from_robot * percept.center_circle->center;
    EXPECT_LT(center.norm(), 0.06) << center.transpose();
    expect_within(center, percept.center_circle->covariance);
    ASSERT_TRUE(percept.center_circle->halfway_direction);
    const double turned = *percept.center_circle->halfway_direction + pose.rotation - 0.5 * kPi;
    EXPECT_LT(std::abs(std::remainder(turned, kPi)), 0.04);
  }
}

TEST(Landmarks, IncludeNoCenterCircleInTheCornerOfAnArea) {
  const FlatField scene;
  for (const Pose2& pose : {Pose2{1.6, 0.8, 0.6}, Pose2{3.2, 0.4, 0.5}, Pose2{3.4, 2.0, 0.6}})
    EXPECT_FALSE(percept_of(scene, at(pose)).center_circle) << pose.position.transpose();
}

TEST(Landmarks, IncludePenaltyMarksAndNoOtherWhiteSpots) {
  FlatField scene;
  scene.marks = true;
  for (const Pose2& pose : {Pose2{1.9, 0.2, 0.0}, Pose2{1.0, -0.3, 0.1}, Pose2{3.0, -1.2, 1.4}}) {
    SCOPED_TRACE(testing::Message() << pose.position.transpose());
    const Stand here = at(pose);
    const FieldPercept percept = percept_of(scene, here);
    ASSERT_EQ(percept.penalty_marks.size(), 1u);
    const Vector2d mark = here.field_from_robot * percept.penalty_marks[0].position;
    EXPECT_LT((mark - Vector2d(3.2, 0.0)).norm(), 0.05) << mark.transpose();
    expect_within(mark - Vector2d(3.2, 0.0), percept.penalty_marks[0].covariance);
  }
  scene.marks = false;
  for (const Pose2& pose : {Pose2{1.9, 0.2, 0.0}, Pose2{3.0, 1.5, 0.4}, Pose2{-1.0, 0.1, 0.0}})
    EXPECT_TRUE(percept_of(scene, at(pose)).penalty_marks.empty()) << pose.position.transpose();
}

TEST(Landmarks, IncludeTheBallOnTheCarpetAndOnLines) {
  FlatField scene;
  const Stand here = at({-1.0, 0.3, 0.0});
  for (const Vector2d& place : {Vector2d(0.4, 0.5), Vector2d(1.5, 0.0), Vector2d(0.0, 0.3), Vector2d(0.53, 0.53)}) {
    SCOPED_TRACE(testing::Message() << place.transpose());
    scene.spheres = {{place}};
    const FieldPercept percept = percept_of(scene, here);
    ASSERT_TRUE(percept.ball);
    const Vector2d seen = here.field_from_robot * percept.ball->position;
    EXPECT_LT((seen - place).norm(), 0.05 * (place - here.field_from_robot.position).norm()) << seen.transpose();
    expect_within(seen - place, percept.ball->covariance);
    EXPECT_TRUE(percept.penalty_marks.empty());
    EXPECT_TRUE(percept.obstacles.empty());
  }
}

TEST(Landmarks, IncludeNoBallWithoutABall) {
  FlatField scene = FlatField::with_goals();
  scene.marks = true;
  scene.boxes.push_back({{0.5, 0.4}, 0.12, 0.5, scene.colors.post});  // a leg
  for (double rotation = -kPi; rotation < kPi; rotation += 0.45) {
    for (const Vector2d& place : {Vector2d(-1.0, 0.3), Vector2d(2.6, 0.9), Vector2d(-3.4, -1.2)}) {
      const Stand here(320, 240, {place.x(), place.y(), rotation}, {0.0, 0.25});
      EXPECT_FALSE(percept_of(scene, here).ball) << place.transpose() << " " << rotation;
    }
  }
}

}  // namespace
}  // namespace reorient
