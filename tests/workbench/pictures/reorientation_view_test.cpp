// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/reorientation_view.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/scene/color.h"

namespace reorient::pictures {
namespace {

// The two panels, below title and legend; the same numbers as in the implementation.
constexpr int kPanelTop = 194;
constexpr int kMiddle = 750;

ReorientationSnapshot flip() {
  const Pose2 truth(3.0, 1.0, 0.0);
  return {46.2, Reorientation::flip_pose, truth, reflect(truth), truth, {Pose2(-3.0, -1.0, 0.0)}, {truth}};
}

TEST(ReorientationView, ShowsTheBeliefJumpToTheTruth) {
  const Picture picture = draw_reorientation_view({}, {flip()});
  const auto believed = [&](int left, int right) {
    return count(picture, palette::belief, left, kPanelTop, right, picture.height);
  };
  EXPECT_GT(believed(36, 386), 60);  // before: on the left of the first panel
  EXPECT_EQ(believed(400, kMiddle), 0);
  EXPECT_EQ(believed(kMiddle + 20, 1100), 0);  // after: on the right of the second one
  EXPECT_GT(believed(1114, 1464), 60);
  EXPECT_GT(count(picture, palette::truth, 400, kPanelTop, kMiddle, picture.height), 100);
}

TEST(ReorientationView, ColorsTheParticlesThatAPurgeRemoves) {
  const Pose2 truth(3.0, 1.0, 0.0);
  const ReorientationSnapshot purge{1.0,   Reorientation::purge_reflection, {},     truth,
                                    truth, {truth, reflect(truth)},         {truth}};
  const Picture picture = draw_reorientation_view({}, {purge});
  const auto mirrored = [&](int left, int right) {
    return count(picture, palette::opposite, left, kPanelTop, right, picture.height);
  };
  EXPECT_GT(mirrored(36, kMiddle), 10);
  EXPECT_EQ(mirrored(kMiddle, 1464), 0);
}

TEST(ReorientationView, HasNoEntryOfTheLegendWithoutItsObject) {
  ReorientationSnapshot one = flip();
  const auto in_legend = [&](Color color) {
    return count(draw_reorientation_view({}, {one}), color, 0, 70, 1500, 106);
  };
  EXPECT_GT(in_legend(palette::truth), 20);
  EXPECT_EQ(in_legend(palette::opposite), 0);
  one.truth.reset();
  EXPECT_EQ(in_legend(palette::truth), 0);
  EXPECT_GT(in_legend(palette::belief), 20);
  const Picture empty = draw_reorientation_view({}, {});
  EXPECT_EQ(count(empty, palette::page, 0, 70, 1500, 106), 1500 * 36);
}

TEST(ReorientationView, DrawsARowForEachCommand) {
  const int one = draw_reorientation_view({}, {flip()}).height;
  const int two = draw_reorientation_view({}, {flip(), flip()}).height;
  const int three = draw_reorientation_view({}, {flip(), flip(), flip()}).height;
  EXPECT_GT(two, one + 400);
  EXPECT_NEAR(three - two, two - one, 1);
}

TEST(ReorientationView, HasALimitedSize) {
  EXPECT_LT(draw_reorientation_view({}, std::vector<ReorientationSnapshot>(500)).height, 8000);
}

TEST(ReorientationView, DrawsARunWithoutCommands) {
  const Picture picture = draw_reorientation_view({}, {});
  EXPECT_EQ(picture.width, 1500);
  EXPECT_EQ(count(picture, palette::carpet), 0);
}

TEST(ReorientationView, OmitsInvalidPoses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Pose2 none(nan, nan, nan);
  const ReorientationSnapshot empty{nan, Reorientation::purge_reflection, {}, none, none, {}, {}};
  const ReorientationSnapshot bad{nan,
                                  Reorientation::purge_reflection,
                                  Pose2(0.0, nan, 0.0),
                                  Pose2(nan, 0.0, 0.0),
                                  none,
                                  {none, Pose2(1e300, 0.0, 0.0)},
                                  {none}};
  EXPECT_EQ(draw_reorientation_view({}, {bad}), draw_reorientation_view({}, {empty}));
}

}  // namespace
}  // namespace reorient::pictures
