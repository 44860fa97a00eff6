// SPDX-License-Identifier: MIT
#include "robots/simulator/render/optics.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "robots/simulator/render/renderer.h"
#include "robots/simulator/render/sensor.h"

namespace reorient {
namespace {

CameraModel lens(int width) {
  return CameraModel::from_fields_of_view(width, width * 3 / 4, from_degrees(56.3), from_degrees(43.7));
}

/// A bright column in the middle of a dark picture.
Frame bright_column(int width) {
  Frame frame(width, width * 3 / 4, false);
  for (int row = 0; row < frame.height; ++row) {
    const std::size_t middle = frame.row(row) + static_cast<std::size_t>(width / 2);
    frame.red[middle] = frame.green[middle] = frame.blue[middle] = 1.0f;
  }
  return frame;
}

/// Standard deviation of the light across the middle row, pixels.
double spread(const Frame& frame) {
  double sum = 0.0, first = 0.0, second = 0.0;
  for (int i = 0; i < frame.width; ++i) {
    const double light = frame.red[frame.row(frame.height / 2) + static_cast<std::size_t>(i)];
    sum += light;
    first += light * i;
    second += light * i * i;
  }
  EXPECT_NEAR(sum, 1.0, 1e-4) << "blur preserves the sum of the light";
  return std::sqrt(std::max(0.0, second / sum - first / sum * first / sum));
}

TEST(Optics, DoNotChangeAnImageWithoutBlur) {
  const RayTable rays(lens(160));
  Optics optics(0.0, 0.0, rays);
  const Frame frame = bright_column(160);
  EXPECT_EQ(&optics.image(frame, {0.0, 0.0, 5.0}), &frame);
}

TEST(Optics, BlurByTheSameAngleAtEachImageSize) {
  for (const int width : {160, 320, 640}) {
    const RayTable rays(lens(width));
    Optics optics(0.004, 0.0, rays);
    const double deviation = spread(optics.image(bright_column(width), Eigen::Vector3d::Zero()));
    EXPECT_NEAR(deviation * static_cast<double>(rays.pixel_angle), 0.004, 0.0003) << width;
  }
}

TEST(Optics, BlurMoreTheFasterTheHeadTurnsAndNotAtRest) {
  const RayTable rays(lens(320));
  Optics optics(0.0, 0.01, rays);
  const Frame frame = bright_column(320);
  EXPECT_EQ(&optics.image(frame, Eigen::Vector3d::Zero()), &frame);
  double before = 0.0;
  for (const double speed : {1.0, 2.0, 4.0}) {
    const double deviation = spread(optics.image(frame, {0.0, 0.0, speed}));
    EXPECT_GT(deviation, before);
    // A box filter of that width, sampled by pixels.
    const double width = speed * 0.01 * rays.camera.focal.x();
    EXPECT_NEAR(deviation, width / std::sqrt(12.0), 0.45) << speed << " rad/s";
    before = deviation;
  }
}

TEST(Optics, DoNotBlurAnEdgeThatMovesAlongItself) {
  const RayTable rays(lens(320));
  Optics optics(0.0, 0.01, rays);
  const Frame& blurred = optics.image(bright_column(320), {0.0, 3.0, 0.0});
  EXPECT_NEAR(spread(blurred), 0.0, 1e-3) << "a rotation in pitch does not blur columns";
}

TEST(Optics, StayWithinThePictureAtEachSpeed) {
  const RayTable rays(lens(160));
  Optics optics(0.02, 0.1, rays);
  const Frame frame = bright_column(160);
  for (const Eigen::Vector3d& speed : {Eigen::Vector3d(0.0, 20.0, -20.0), Eigen::Vector3d(3.0, -20.0, 20.0)}) {
    const Frame& blurred = optics.image(frame, speed);
    for (const float light : blurred.red) ASSERT_TRUE(light >= 0.0f && light <= 1.0f);
  }
}

/// The column, with subpixel precision, at which a row of a picture changes from dark to bright.
double edge_in(const Frame& frame, int row) {
  for (int i = 1; i < frame.width; ++i) {
    const double left = frame.red[frame.row(row) + static_cast<std::size_t>(i - 1)];
    const double right = frame.red[frame.row(row) + static_cast<std::size_t>(i)];
    if (left < 0.5 && right >= 0.5) return i - 1 + (0.5 - left) / (right - left);
  }
  return -1.0;
}

/// A room whose wall ahead is bright on the right, dark on the left.
Room divided_room() {
  Room room;
  const double perimeter = wall_perimeter(room.shape);
  LinearImage walls(4096, 64, LinearColor::Constant(0.0f));
  for (int i = 0; i < walls.width; ++i) {
    if ((i + 0.5) * perimeter / walls.width > 0.5 * room.shape.width) continue;
    for (int j = 0; j < walls.height; ++j) walls.at(i, j) = LinearColor::Ones();
  }
  room.walls = {walls, {}, {perimeter, room.shape.height}, Texture::Edge::wrap};
  room.floor = {LinearImage(64, 64), {}, floor_extent(room.shape), Texture::Edge::clamp};
  room.ceiling = room.floor;
  return room;
}

TEST(RollingShutter, SkewsAVerticalEdgeByReadoutTimeTimesSpeed) {
  const CameraModel camera = lens(320);
  Renderer renderer(camera, FieldDimensions{}, divided_room(), false);
  Isometry3 eye = Isometry3::Identity();
  eye.translation().z() = 3.5;
  constexpr double kReadout = 0.03;
  constexpr int kTop = 60, kBottom = 180;
  const Frame still = renderer.render(eye, Scene{}, Eigen::Vector3d::Zero(), kReadout);
  EXPECT_NEAR(edge_in(still, kTop), edge_in(still, kBottom), 0.05);
  for (const double speed : {-2.0, 1.0, 3.0}) {
    const Frame& skewed = renderer.render(eye, Scene{}, {0.0, 0.0, speed}, kReadout);
    const double fraction = static_cast<double>(kBottom - kTop) / camera.height;
    const double moved = edge_in(skewed, kBottom) - edge_in(skewed, kTop);
    // The camera turns to the left, so static things are farther to the right in later rows.
    constexpr double kEdge = 0.6;  // pixels, precision of the edge detection
    EXPECT_NEAR(moved, fraction * speed * kReadout * camera.focal.x(), kEdge) << speed << " rad/s";
    EXPECT_NEAR(edge_in(skewed, 120), edge_in(still, 120), 0.2) << "the middle row has the camera's pose";
  }
}

TEST(RollingShutter, SkewsThingsInFrontOfTheWallLikeTheWall) {
  const CameraModel camera = lens(320);
  Renderer renderer(camera, FieldDimensions{}, divided_room(), false);
  Isometry3 eye = Isometry3::Identity();
  eye.translation().z() = 1.0;
  Scene scene;
  scene.capsules.push_back(
      {{4.0f, -10.0f, 0.0f}, {4.0f, -10.0f, 0.0f}, 0.1f, LinearColor::Ones(), Label::goal, true, false});
  scene.capsules.push_back(
      {{4.0f, 0.0f, -0.5f}, {4.0f, 0.0f, 2.5f}, 0.5f, LinearColor::Constant(9.0f), Label::goal, true, false});
  const Frame& skewed = renderer.render(eye, scene, {0.0, 0.0, 4.0}, 0.03);
  const auto right_side = [&](int row) {
    int last = -1;
    for (int i = 0; i < camera.width; ++i) {
      if (skewed.depth[skewed.row(row) + static_cast<std::size_t>(i)] < 4.2f) last = i;
    }
    return last;
  };
  EXPECT_NEAR(right_side(150) - right_side(60), 90.0 / 240.0 * 4.0 * 0.03 * camera.focal.x(), 2.0);
}

TEST(Sensor, IsNoisierIfItAmplifiesADarkImage) {
  const RayTable rays(lens(160));
  const auto noise = [&](double noise_gain, float light) {
    SensorParameters parameters;
    parameters.noise_gain = noise_gain;
    parameters.vignetting = 0.0;
    Sensor sensor(parameters, rays, 1);
    Frame frame(160, 120, false);
    frame.red.assign(frame.size(), light);
    frame.green = frame.blue = frame.red;
    Image image(160, 120);
    sensor.expose(frame, 0, 1.0 / 30.0, image);
    double sum = 0.0, squares = 0.0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        const double luma = image.view().luma(x, y);
        sum += luma / 19200.0;
        squares += luma * luma / 19200.0;
      }
    }
    return std::sqrt(squares - sum * sum);
  };
  const double at_rest = noise(0.0, 0.05f);
  EXPECT_NEAR(noise(0.0, 0.3f), at_rest, 0.1);
  EXPECT_NEAR(noise(1.0, 0.3f), at_rest, 0.1) << "bright enough for a gain of 1";
  EXPECT_NEAR(noise(1.0, 0.05f) / at_rest, 0.17 / 0.05, 0.2);
  EXPECT_NEAR(noise(0.5, 0.05f) / at_rest, std::sqrt(0.17 / 0.05), 0.15);
}

}  // namespace
}  // namespace reorient
