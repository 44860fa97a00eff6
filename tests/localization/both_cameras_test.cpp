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

TEST(BothCameras, KeepTheLinePointsOfBoth) {
  FieldPercept upper, lower, merged;
  upper.line_points.resize(3);
  lower.line_points.resize(2);
  merge(upper, lower, merged);
  EXPECT_EQ(merged.line_points.size(), 5u);
}

TEST(BothCameras, SeeOnePostAsOneAndBelieveTheCameraThatSeesItsBase) {
  FieldPercept upper, lower, merged;
  upper.goal_posts = {post_at(1.4, 0.1, false), post_at(3.0, 1.5)};
  lower.goal_posts = {post_at(1.0, 0.08)};
  merge(upper, lower, merged);
  ASSERT_EQ(merged.goal_posts.size(), 2u);
  EXPECT_TRUE(merged.goal_posts[0].base_visible);
  EXPECT_EQ(merged.goal_posts[0].position.x(), 1.0);
}

TEST(BothCameras, SeeTwoPostsWhereTheyAreApart) {
  FieldPercept upper, lower, merged;
  upper.goal_posts = {post_at(3.0, 0.0)};
  lower.goal_posts = {post_at(1.0, 0.0), post_at(0.5, 0.5)};
  merge(upper, lower, merged);
  EXPECT_EQ(merged.goal_posts.size(), 3u) << "one stands behind the other";
}

TEST(BothCameras, OfWhichOneIsBlindAreTheOtherOne) {
  FieldPercept upper, nothing, merged;
  upper.line_points.resize(3);
  upper.goal_posts = {post_at(3.0, 0.0)};
  merge(nothing, upper, merged);
  EXPECT_EQ(merged.line_points.size(), 3u);
  EXPECT_EQ(merged.goal_posts.size(), 1u);
}

}  // namespace
}  // namespace reorient
