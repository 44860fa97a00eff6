// SPDX-License-Identifier: MIT
#include "localization/measurement/both_cameras.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

GoalPost post_at(double x, double y, bool base_visible = true) {
  GoalPost post;
  post.position = {x, y};
  post.base_visible = base_visible;
  return post;
}

TEST(BothCameras, MergeTheLinePointsOfBoth) {
  FieldPercept upper, lower, merged;
  upper.line_points.resize(3);
  lower.line_points.resize(2);
  merge(upper, lower, merged);
  EXPECT_EQ(merged.line_points.size(), 5u);
}

TEST(BothCameras, MergeAPostInBothImagesAndPreferTheCameraThatSeesItsBase) {
  FieldPercept upper, lower, merged;
  upper.goal_posts = {post_at(1.4, 0.1, false), post_at(3.0, 1.5)};
  lower.goal_posts = {post_at(1.0, 0.08)};
  merge(upper, lower, merged);
  ASSERT_EQ(merged.goal_posts.size(), 2u);
  EXPECT_TRUE(merged.goal_posts[0].base_visible);
  EXPECT_EQ(merged.goal_posts[0].position.x(), 1.0);
}

TEST(BothCameras, DoNotMergePostsThatAreApart) {
  FieldPercept upper, lower, merged;
  upper.goal_posts = {post_at(3.0, 0.0)};
  lower.goal_posts = {post_at(1.0, 0.0), post_at(0.5, 0.5)};
  merge(upper, lower, merged);
  EXPECT_EQ(merged.goal_posts.size(), 3u) << "one stands behind the other";
}

template <typename Seen>
Seen seen_at(double x, double y, double variance) {
  Seen seen;
  seen.position = {x, y};
  seen.covariance = variance * Eigen::Matrix2d::Identity();
  return seen;
}

TEST(BothCameras, TakeTheMoreCertainMeasurementOfALandmarkInBothImages) {
  FieldPercept upper, lower, merged;
  upper.intersections = {seen_at<Intersection>(1.0, 0.0, 0.04), seen_at<Intersection>(3.0, 0.0, 0.1)};
  lower.intersections = {seen_at<Intersection>(1.1, 0.0, 0.01), seen_at<Intersection>(0.4, 0.8, 0.01)};
  upper.penalty_marks = {seen_at<PenaltyMark>(2.0, 0.0, 0.01)};
  lower.penalty_marks = {seen_at<PenaltyMark>(2.1, 0.0, 0.02)};
  lower.ball = seen_at<Ball>(0.3, 0.1, 0.01);
  upper.center_circle = CenterCircle{{2.0, 1.0}, 0.01 * Eigen::Matrix2d::Identity(), 0.5, 0.001};
  lower.center_circle = CenterCircle{{2.2, 1.0}, 0.02 * Eigen::Matrix2d::Identity(), std::nullopt, 0.0};
  merge(upper, lower, merged);
  ASSERT_EQ(merged.intersections.size(), 3u);
  EXPECT_EQ(merged.intersections[0].position.x(), 1.1);
  ASSERT_EQ(merged.penalty_marks.size(), 1u);
  EXPECT_EQ(merged.penalty_marks[0].position.x(), 2.0);
  ASSERT_TRUE(merged.ball);
  EXPECT_EQ(merged.ball->position.y(), 0.1);
  ASSERT_TRUE(merged.center_circle);
  EXPECT_EQ(merged.center_circle->center.x(), 2.0);
}

TEST(BothCameras, GiveThePerceptOfTheOtherCameraWhenOneSeesNothing) {
  FieldPercept upper, nothing, merged;
  upper.line_points.resize(3);
  upper.goal_posts = {post_at(3.0, 0.0)};
  merge(nothing, upper, merged);
  EXPECT_EQ(merged.line_points.size(), 3u);
  EXPECT_EQ(merged.goal_posts.size(), 1u);
}

}  // namespace
}  // namespace reorient
