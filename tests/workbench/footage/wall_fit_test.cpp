// SPDX-License-Identifier: MIT
// The wall that is fitted to images of a round room of known size.
#include "workbench/footage/wall_fit.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace reorient {
namespace {

/// A smooth random pattern in [0, 1] on the wall, in cells of about 0.15 rad x 0.15 rad.
double pattern(double azimuth, double height_over_radius) {
  const double u = azimuth / 0.15, v = height_over_radius / 0.15;
  const auto cell = [](double x, double y) {
    const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x) + 1000);
    const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(y) + 1000);
    return static_cast<double>(scatter(column * 7919 + row) >> 40) / static_cast<double>(1 << 24);
  };
  const double x = std::floor(u), y = std::floor(v), right = u - x, up = v - y;
  return (1.0 - up) * ((1.0 - right) * cell(x, y) + right * cell(x + 1, y)) +
         up * ((1.0 - right) * cell(x, y + 1) + right * cell(x + 1, y + 1));
}

FootageFrame image_at(const Pose2& pose, double radius, double contrast) {
  FootageFrame frame;
  frame.image = Image(160, 120);
  frame.camera = CameraModel::from_fields_of_view(160, 120, from_degrees(60.0), from_degrees(47.0));
  frame.robot_from_camera.translation().z() = 0.5;
  frame.pose = pose;
  const Isometry3 camera = to_isometry(pose) * frame.robot_from_camera;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Eigen::Vector3d ray = camera.linear() * frame.camera.ray({static_cast<double>(x), static_cast<double>(y)});
      const Eigen::Vector2d p = camera.translation().head<2>(), d = ray.head<2>();
      const double a = d.squaredNorm(), b = p.dot(d), c = p.squaredNorm() - radius * radius;
      const Eigen::Vector3d point = camera.translation() + (std::sqrt(b * b - a * c) - b) / a * ray;
      const double shade = pattern(std::atan2(point.y(), point.x()), point.z() / radius);
      frame.image.row(y)[2 * x] = static_cast<std::uint8_t>(128.0 + contrast * (shade - 0.5));
      frame.image.row(y)[2 * x + 1] = 128;
    }
  }
  return frame;
}

std::vector<WallView> views_in(double radius, double walked, double contrast) {
  Random random(3);
  std::vector<WallView> views;
  for (int i = 0; i < 28; ++i) {
    const Pose2 pose(random.uniform(-walked, walked), random.uniform(-walked, walked), random.uniform(-kPi, kPi));
    views.push_back(*wall_view(image_at(pose, radius, contrast)));
  }
  return views;
}

TEST(WallFit, FindsTheRadiusOfARoundRoom) {
  for (const double radius : {2.5, 4.0, 7.0}) {
    const auto fit = fit_wall(views_in(radius, 0.25 * radius, 200.0));
    ASSERT_TRUE(fit) << radius;
    EXPECT_NEAR(fit->radius, radius, 0.15 * radius);
    EXPECT_LE(fit->low, fit->radius);
    EXPECT_GE(fit->high, fit->radius);
  }
}

TEST(WallFit, FindsNothingIfTheRobotOnlyRotated) { EXPECT_FALSE(fit_wall(views_in(4.0, 0.0, 200.0))); }

TEST(WallFit, FindsNothingInEmptyImages) { EXPECT_FALSE(fit_wall(views_in(4.0, 1.0, 0.0))); }

TEST(WallFit, FindsNothingWithoutImages) { EXPECT_FALSE(fit_wall({})); }

TEST(WallFit, IsAsHighAsTheImagesReach) {
  const std::vector<WallView> views = views_in(4.0, 1.0, 200.0);
  const WallParameters wall = wall_of(4.0, views, {});
  EXPECT_EQ(wall.radius, 4.0);
  EXPECT_EQ(wall.bottom, 0.25);  // half the eye's height
  EXPECT_NEAR(wall.top, 0.5 + 4.0 * std::tan(from_degrees(23.5)), 0.1);
  EXPECT_EQ(wall.columns, WallParameters().columns);
  const double column = 2.0 * kPi * wall.radius / wall.columns;
  EXPECT_NEAR((wall.top - wall.bottom) / wall.rows, column, 0.4 * column);
}

TEST(WallFit, NeedsAPose) {
  FootageFrame frame = image_at(Pose2(), 4.0, 100.0);
  frame.pose.reset();
  EXPECT_FALSE(wall_view(frame));
}

}  // namespace
}  // namespace reorient
