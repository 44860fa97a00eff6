// SPDX-License-Identifier: MIT
#include "perception/room/evidence/informative_views.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/angle.h"

namespace reorient {
namespace {

constexpr double kStep = 1.0 / 30.0;      // s
constexpr double kLeastIncidence = 0.45;  // cosine

Isometry3 camera_at(double yaw) {
  Isometry3 camera = Isometry3::Identity();
  camera.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  camera.translation().z() = 0.5;
  return camera;
}

/// A gray room with red on the wall between two azimuths, all of it known. The robot stands in the center.
struct GrayRoom {
  explicit GrayRoom(double red_from, double red_to) {
    model.forget(wall.tiles());
    views.restart(wall.columns());
    for (int tile = 0; tile < wall.tiles(); ++tile) {
      const double azimuth = normalize_angle((wall.column_of(tile) + 0.5) * wall.column_width());
      ColorHistogram colors{};
      colors[azimuth > red_from && azimuth < red_to ? 4 : 0] = 1.0f;
      model.train(tile, colors, {1.0, 100.0, true, 0.0});
    }
    compared.prepare(model, wall, Comparison{});
  }
  const InformativeViews& choose(double yaw, double step = kStep) {
    return views.choose(wall, compared, Pose2(), camera_at(yaw), step, kLeastIncidence, parameters);
  }

  Wall wall;
  BackgroundModel model;
  ComparedModel compared;
  ViewParameters parameters;
  ViewChooser views;
};

TEST(ViewChooser, ChoosesTheViewThatDiffersFromItsReflection) {
  GrayRoom room(0.8, 1.4);
  EXPECT_NEAR(room.choose(0.0).best_yaw, 1.1, 0.2);
  EXPECT_GT(room.choose(0.0).best_score, 5.0);
}

TEST(ViewChooser, ChoosesStraightAheadIfTheReachIsNegativeOrNotANumber) {
  for (const double reach : {0.0, -1.0, -1e300, std::nan("")}) {
    GrayRoom room(0.0, 0.4);
    room.parameters.reach = reach;
    EXPECT_LE(std::abs(room.choose(0.0).best_yaw), room.parameters.half_width) << reach;
  }
}

TEST(ViewChooser, ChoosesAnotherViewAfterAViewWasUsed) {
  GrayRoom room(-2.0, 2.0);
  const double first = room.choose(0.0).best_yaw;
  double second = first;
  for (int frame = 0; frame < 30; ++frame) second = room.choose(first).best_yaw;
  EXPECT_GT(std::abs(second - first), 0.3);
  for (int frame = 0; frame < 600; ++frame) room.choose(1.5);
  EXPECT_LT(room.choose(1.5).best_yaw, 0.8) << "the viewing time of the first view has faded";
}

TEST(ViewChooser, PrefersNearViews) {
  GrayRoom room(-2.0, 2.0);
  room.parameters.speed = 0.2;
  EXPECT_NEAR(room.choose(0.9).best_yaw, 0.9, 0.1);
  room.views.restart(room.wall.columns());
  EXPECT_NEAR(room.choose(-0.5).best_yaw, -0.5, 0.1);
}

TEST(ViewChooser, FindsNoInformativeViewInAUniformRoom) {
  GrayRoom room(9.0, 9.0);
  EXPECT_EQ(room.choose(0.3).best_score, 0.0);
  EXPECT_EQ(room.choose(0.3).unknown_score, 0.0);
}

TEST(ViewChooser, FindsUnknownParts) {
  GrayRoom room(9.0, 9.0);
  room.model.forget(room.wall.tiles());
  for (int tile = 0; tile < room.wall.tiles(); ++tile) {
    const double azimuth = normalize_angle((room.wall.column_of(tile) + 0.5) * room.wall.column_width());
    if (azimuth < -0.6 && azimuth > -1.2) continue;
    ColorHistogram colors{};
    colors[0] = 1.0f;
    room.model.train(tile, colors, {1.0, 100.0, true, 0.0});
  }
  room.compared.clear();
  room.compared.prepare(room.model, room.wall, Comparison{});
  EXPECT_NEAR(room.choose(0.5).unknown_yaw, -0.9, 0.3);
  EXPECT_GE(room.choose(0.5).unknown_score, 3.0 * room.wall.rows());
}

TEST(ViewChooser, KeepsViewingTimesAfterARotationBy180Degrees) {
  GrayRoom room(-3.2, 3.2);
  GrayRoom turned = room;
  for (int frame = 0; frame < 60; ++frame) {
    room.choose(0.4);
    turned.choose(0.4);
  }
  turned.views.rotate_by_180_degrees();
  const Pose2 reflected(0.0, 0.0, kPi);
  EXPECT_EQ(
      turned.views.choose(turned.wall, turned.compared, reflected, camera_at(0.4), kStep, kLeastIncidence, {}).best_yaw,
      room.choose(0.4).best_yaw);
}

TEST(ViewChooser, GivesNoViewOutsideOfTheWallOrAtAnInvalidPose) {
  GrayRoom room(0.8, 1.4);
  for (const Pose2& belief : {Pose2(20.0, 0.0, 0.0), Pose2(0.0, 0.0, std::numeric_limits<double>::quiet_NaN()),
                              Pose2(std::numeric_limits<double>::infinity(), 0.0, 0.0)}) {
    const InformativeViews& views =
        room.views.choose(room.wall, room.compared, belief, camera_at(0.0), kStep, kLeastIncidence, room.parameters);
    EXPECT_EQ(views.best_score, 0.0);
    EXPECT_EQ(views.best_yaw, 0.0);
  }
}

}  // namespace
}  // namespace reorient
