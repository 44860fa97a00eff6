// SPDX-License-Identifier: MIT
// Parts of the peers: the horizon in an image, color classes, features of a row of brightness, a dome of
// triangles.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/perception/room/painted_room.h"
#include "workbench/experiments/peers/color_classes.h"
#include "workbench/experiments/peers/horizon.h"
#include "workbench/experiments/peers/horizon_features.h"
#include "workbench/experiments/peers/triangle_dome.h"

namespace reorient {
namespace {

RoomObservation level_view(const Image& image) {
  RoomObservation view;
  view.image = image.view();
  view.camera = test::small_camera();
  view.robot_from_camera = Isometry3::Identity();
  view.robot_from_camera.translation().z() = 0.5;
  return view;
}

TEST(HorizonCamera, FindsTheHorizonWhereALevelCameraHasIt) {
  const Image image(160, 120);
  const RoomObservation view = level_view(image);
  const Wall wall = bare_wall(8.0);
  const auto camera = HorizonCamera::of(view, wall);
  ASSERT_TRUE(camera);
  std::vector<HorizonColumn> columns;
  camera->find(40, columns);
  ASSERT_EQ(columns.size(), 40U);
  for (const HorizonColumn& column : columns) {
    EXPECT_NEAR(column.row, view.camera.center.y(), 1e-6);
    EXPECT_FALSE(column.covered);
    EXPECT_NEAR(column.azimuth, std::atan2(view.camera.center.x() - column.x, view.camera.focal.x()), 1e-9);
  }
}

TEST(HorizonCamera, FollowsTheBeliefTheTiltAndTheDistortion) {
  const Image image(160, 120);
  RoomObservation view = level_view(image);
  view.camera.k1 = -0.05;
  view.belief = Pose2(2.0, -1.0, 2.0);
  view.robot_from_camera.linear() = rotation_about_z(0.3) * rotation_about_y(0.1) * rotation_about_x(0.05);
  const Wall wall = bare_wall(8.0);
  const auto camera = HorizonCamera::of(view, wall);
  ASSERT_TRUE(camera);
  std::vector<HorizonColumn> columns;
  camera->find(20, columns);
  ASSERT_EQ(columns.size(), 20U);
  for (const HorizonColumn& column : columns) {
    // A point on the wall at the camera's height lies there in the image.
    const Eigen::Vector3d point(8.0 * std::cos(column.azimuth), 8.0 * std::sin(column.azimuth), 0.5);
    const auto pixel = view.camera.project((to_isometry(view.belief) * view.robot_from_camera).inverse() * point);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), column.x, 0.01);
    EXPECT_NEAR(pixel->y(), column.row, 0.01);
  }
}

TEST(HorizonCamera, ReportsWhichColumnsAreCovered) {
  const Image image(160, 120);
  RoomObservation view = level_view(image);
  const std::vector<CoveredArea> covered{{40, 30, 60, 90}, {100, 70, 120, 119}};  // the second one below the horizon
  view.covered = covered;
  const Wall wall = bare_wall(8.0);
  std::vector<HorizonColumn> columns;
  HorizonCamera::of(view, wall)->find(160, columns);
  for (const HorizonColumn& column : columns) EXPECT_EQ(column.covered, column.x >= 40 && column.x <= 60) << column.x;
}

TEST(Sectors, HaveTheirReflectionsHalfOfTheCircleAway) {
  for (const double azimuth : {-3.1, -1.0, -0.01, 0.0, 0.5, 3.0, kPi})
    EXPECT_EQ(sector_of(normalize_angle(azimuth + kPi), 80), reflected_sector(sector_of(azimuth, 80), 80)) << azimuth;
  EXPECT_EQ(sector_of(-1e-18, 80), 79);
}

TEST(ColorClasses, DistinguishTheColorsOfARoom) {
  std::vector<Ycbcr> colors;
  for (int i = 0; i < 300; ++i) {
    const auto grain = static_cast<std::uint8_t>(i % 7);
    colors.push_back({static_cast<std::uint8_t>(60 + grain), 100, 150});
    colors.push_back({static_cast<std::uint8_t>(60 + grain), 150, 100});
    colors.push_back({static_cast<std::uint8_t>(200 + grain), 128, 128});
  }
  const ColorClasses classes = ColorClasses::of(colors, 3, 2.0, 1);
  ASSERT_EQ(classes.count(), 3);
  for (std::size_t i = 3; i < colors.size(); ++i) EXPECT_EQ(classes(colors[i]), classes(colors[i % 3]));
  EXPECT_NE(classes(colors[0]), classes(colors[1]));
  EXPECT_NE(classes(colors[0]), classes(colors[2]));
  EXPECT_NE(classes(colors[1]), classes(colors[2]));
}

TEST(ColorClasses, AreAsManyAsThereAreColors) {
  EXPECT_EQ(ColorClasses::of({}, 10, 1.0, 1).count(), 0);
  EXPECT_EQ(ColorClasses::of(std::vector<Ycbcr>(50, {10, 20, 30}), 10, 1.0, 1).count(), 1);
}

TEST(RunningLight, RemovesTheLight) {
  RunningLight light;
  for (int i = 0; i < 100; ++i) light.add({60, 140, 120});
  light.next_frame(1.0, 5.0);
  EXPECT_EQ(light.without_light({60, 140, 120}), (Ycbcr{115, 128, 128}));
  EXPECT_EQ(light.without_light({0, 128, 128}).y, 0);
}

TEST(RunningLight, DoesNotChangeColorsWithoutMemory) {
  RunningLight light;
  for (int i = 0; i < 100; ++i) light.add({60, 140, 120});
  light.next_frame(1.0, 0.0);
  EXPECT_EQ(light.without_light({60, 140, 120}), (Ycbcr{60, 140, 120}));
}

std::vector<float> row_with_bars(float gain, int shift) {
  std::vector<float> row(160, gain * 60.0f);
  for (const auto& [place, width, bright] :
       {std::tuple(50, 6, 120.0f), std::tuple(70, 8, 20.0f), std::tuple(95, 5, 200.0f)}) {
    for (int i = 0; i < width; ++i) row[static_cast<std::size_t>(place + shift + i)] = gain * bright;
  }
  return row;
}

TEST(HorizonFeatures, DependNeitherOnPositionNorOnBrightness) {
  HorizonFeatureFinder finder, other;
  const auto first = finder.find(row_with_bars(1.0f, 0), 0.04);
  const auto second = other.find(row_with_bars(0.5f, 7), 0.04);
  ASSERT_GE(first.size(), 3U);
  for (const HorizonFeature& feature : first) {
    const auto found = std::find_if(second.begin(), second.end(), [&](const HorizonFeature& one) {
      return one.place == feature.place + 7 && one.filter == feature.filter;
    });
    if (found == second.end()) continue;  // its surroundings may reach beyond the row here
    EXPECT_EQ(found->bright, feature.bright);
    EXPECT_LT(distance(found->descriptor, feature.descriptor), 1e-3);
  }
  EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](const auto& one) { return one.bright; }));
  EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](const auto& one) { return !one.bright; }));
}

TEST(HorizonFeatures, AreNotFoundInAnEvenRow) {
  HorizonFeatureFinder finder;
  EXPECT_TRUE(finder.find(std::vector<float>(160, 90.0f), 0.04).empty());
  EXPECT_TRUE(finder.find(std::vector<float>(160, 0.0f), 0.04).empty());
  EXPECT_TRUE(finder.find(std::vector<float>(7, 90.0f), 0.0).empty());
  EXPECT_TRUE(finder.find({}, 0.04).empty());
}

TEST(TriangleDome, HasTwentyFacesOfEqualTriangles) {
  for (const int cuts : {1, 2, 5}) {
    const TriangleDome dome(10.0, cuts);
    EXPECT_EQ(dome.tiles(), 20 * cuts * cuts);
  }
}

TEST(TriangleDome, FindsEachTriangleFromAnyPointInside) {
  const TriangleDome dome(10.0, 4);
  for (const Eigen::Vector3d& eye : {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(-4.5, 2.0, 0.5)}) {
    for (int tile = 0; tile < dome.tiles(); ++tile) {
      const Eigen::Vector3d center = dome.center(tile);
      const auto hit = dome.meet(eye, center - eye);
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->tile, tile);
      EXPECT_NEAR(hit->height, center.z(), 1e-9);
    }
  }
}

TEST(TriangleDome, IsSymmetricUnderARotationBy180Degrees) {
  const TriangleDome dome(10.0, 3);
  for (int tile = 0; tile < dome.tiles(); ++tile) {
    const int other = dome.reflected(tile);
    EXPECT_NE(other, tile);
    EXPECT_EQ(dome.reflected(other), tile);
    const Eigen::Vector3d here = dome.center(tile), there = dome.center(other);
    EXPECT_NEAR((here - Eigen::Vector3d(-there.x(), -there.y(), there.z())).norm(), 0.0, 1e-9);
  }
}

TEST(TriangleDome, CoversTheCeiling) {
  const TriangleDome dome(10.0, 4);
  const auto up = dome.meet({0.0, 0.0, 0.5}, {0.01, 0.02, 1.0});
  ASSERT_TRUE(up);
  EXPECT_GT(up->height, 8.0);
}

TEST(TriangleDome, HasNoTriangleForRaysFromOutsideOrWithoutDirection) {
  const TriangleDome dome(10.0, 4);
  EXPECT_FALSE(dome.meet({12.0, 0.0, 0.5}, {1.0, 0.0, 0.0}));
  EXPECT_FALSE(dome.meet({0.0, 0.0, 0.5}, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(dome.meet({0.0, 0.0, 0.5}, {std::nan(""), 0.0, 1.0}));
}

}  // namespace
}  // namespace reorient
