// SPDX-License-Identifier: MIT
#include "robots/footage/camera_info.h"

#include <string>

#include <gtest/gtest.h>

#include "robots/footage/footage.h"

namespace reorient {
namespace {

messages::CameraInfo info_of(int width, int height) {
  messages::CameraInfo info;
  info.width = static_cast<std::uint32_t>(width);
  info.height = static_cast<std::uint32_t>(height);
  info.distortion_model = "plumb_bob";
  info.d = {-0.2, 0.05, 0.0, 0.0, 0.0};
  info.k = {600.0, 0.0, 321.5, 0.0, 610.0, 241.5, 0.0, 0.0, 1.0};
  info.p = {500.0, 0.0, 311.5, 0.0, 0.0, 510.0, 231.5, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

std::string error_of(const messages::CameraInfo& info, int width = 640, int height = 480) {
  try {
    static_cast<void>(camera_of(info, width, height, false));
  } catch (const BadFootage& bad) {
    return bad.what();
  }
  return {};
}

TEST(CameraInfo, BecomesACameraModel) {
  const CameraModel camera = camera_of(info_of(640, 480), 640, 480, false);
  EXPECT_EQ(camera.focal, Eigen::Vector2d(600.0, 610.0));
  EXPECT_EQ(camera.center, Eigen::Vector2d(321.5, 241.5));
  EXPECT_EQ(camera.k1, -0.2);
  EXPECT_EQ(camera.k2, 0.05);
}

TEST(CameraInfo, OfARectifiedImageUsesItsProjection) {
  const CameraModel camera = camera_of(info_of(640, 480), 640, 480, true);
  EXPECT_EQ(camera.focal, Eigen::Vector2d(500.0, 510.0));
  EXPECT_EQ(camera.center, Eigen::Vector2d(311.5, 231.5));
  EXPECT_EQ(camera.k1, 0.0);
}

TEST(CameraInfo, IsScaledToTheImage) {
  const CameraModel camera = camera_of(info_of(640, 480), 320, 240, false);
  EXPECT_EQ(camera.width, 320);
  EXPECT_EQ(camera.focal, Eigen::Vector2d(300.0, 305.0));
  EXPECT_EQ(camera.center, Eigen::Vector2d(160.5, 120.5));  // (321.5 + 0.5) / 2 - 0.5
}

TEST(CameraInfo, OfARegionMovesTheCenter) {
  messages::CameraInfo info = info_of(640, 480);
  info.region = {160, 120, 320, 240};
  const CameraModel camera = camera_of(info, 320, 240, false);
  EXPECT_EQ(camera.focal, Eigen::Vector2d(600.0, 610.0));
  EXPECT_EQ(camera.center, Eigen::Vector2d(161.5, 121.5));
}

TEST(CameraInfo, OfOddWidthLosesItsLastColumn) {
  const CameraModel camera = camera_of(info_of(641, 480), 640, 480, false);
  EXPECT_EQ(camera.width, 640);
  EXPECT_EQ(camera.focal.x(), 600.0);
  EXPECT_EQ(camera.center.x(), 321.5);
}

TEST(CameraInfo, ThatCannotBeUsedIsRefusedWithOneLine) {
  EXPECT_EQ(error_of(info_of(640, 480), 640, 360),
            "camera calibration: expected the aspect ratio of the image, 640x360, found 640x480");
  messages::CameraInfo info = info_of(640, 480);
  info.k = {};
  EXPECT_EQ(
      error_of(info),
      "camera calibration: expected positive focal lengths and a center, found focal lengths 0 and 0, center 0 and 0");
  info = info_of(0, 480);
  EXPECT_EQ(error_of(info), "camera calibration: expected a width and a height, found 0x480");
  info = info_of(640, 480);
  info.distortion_model = "omnidirectional";
  EXPECT_NE(error_of(info).find("found 'omnidirectional'"), std::string::npos) << error_of(info);
  info.d = {};
  EXPECT_EQ(error_of(info), "") << "without coefficients a pinhole is meant";
  info = info_of(640, 480);
  info.d = {0.1, 0.0, 0.0};
  EXPECT_NE(error_of(info).find("distortion model 'plumb_bob': "), std::string::npos) << error_of(info);
  info.d = {-3.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_NE(error_of(info).find("camera calibration: "), std::string::npos) << "it folds back: " << error_of(info);
}

TEST(CameraInfo, MayHaveAnyOfTheLensModels) {
  messages::CameraInfo info = info_of(640, 480);
  info.d = {-0.1, 0.02, 0.001, -0.002, 0.003};
  CameraModel camera = camera_of(info, 640, 480, false);
  EXPECT_EQ(camera.p1, 0.001);
  EXPECT_EQ(camera.p2, -0.002);
  EXPECT_EQ(camera.k3, 0.003);
  info.distortion_model = "rational_polynomial";
  info.d = {-0.1, 0.02, 0.001, -0.002, 0.003, 0.01, 0.02, 0.03};
  camera = camera_of(info, 640, 480, false);
  EXPECT_EQ(camera.k4, 0.01);
  EXPECT_EQ(camera.k6, 0.03);
  info.d.resize(14, 0.0);
  EXPECT_EQ(camera_of(info, 640, 480, false), camera) << "more zeros change nothing";
  info.distortion_model = "equidistant";
  info.k[0] = info.k[4] = 250.0;
  info.d = {0.01, -0.001, 0.0, 0.0};
  camera = camera_of(info, 640, 480, false);
  EXPECT_EQ(camera.projection, CameraProjection::fisheye);
  EXPECT_EQ(camera.k1, 0.01);
  info.d = {0.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(camera_of(info, 640, 480, false).projection, CameraProjection::fisheye);
}

}  // namespace
}  // namespace reorient
