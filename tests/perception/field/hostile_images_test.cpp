// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/head.h"
#include "geometry/random.h"
#include "perception/field/field_features.h"
#include "tests/perception/field/filled_image.h"
#include "tests/perception/field/percept_in.h"
#include "tests/perception/field/sane_percept.h"

namespace reorient {
namespace {

const Isometry3 kUpright = robot_from_camera({}, {0.0, 0.2}, {}, 0.248);

CameraModel camera_of(int width, int height) {
  return CameraModel::from_fields_of_view(width, height, from_degrees(56.3), from_degrees(43.7));
}

Image noise(int width, int height, std::uint64_t seed) {
  Random random(seed);
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int i = 0; i < 2 * width; ++i) image.row(y)[i] = static_cast<std::uint8_t>(random.below(256));
  }
  return image;
}

void expect_sane(const FieldPercept& percept, int width, int height) {
  EXPECT_EQ(mistake_in(percept, width, height), "");
}

TEST(HostileImages, WithoutPixelsShowNothing) {
  FieldFeatures features({}, {});
  const FieldPercept percept = percept_in(features, {}, camera_of(640, 480), kUpright);
  EXPECT_TRUE(percept.line_points.empty() && percept.goal_posts.empty() && percept.obstacles.empty());
  expect_sane(percept, 0, 0);
}

TEST(HostileImages, OfOneColorShowNothing) {
  for (const Ycbcr& color : {Ycbcr{0, 128, 128}, Ycbcr{255, 128, 128}, Ycbcr{255, 255, 255}, Ycbcr{0, 0, 0}}) {
    FieldFeatures features({}, {});
    const Image image = filled(640, 480, color);
    const FieldPercept percept = percept_in(features, image.view(), camera_of(640, 480), kUpright);
    EXPECT_TRUE(percept.line_points.empty() && percept.goal_posts.empty() && percept.obstacles.empty());
  }
}

TEST(HostileImages, OfPlainCarpetShowOnlyCarpet) {
  FieldFeatures features({}, {});
  const Image image = filled(320, 240, {75, 105, 108});
  const FieldPercept percept = percept_in(features, image.view(), camera_of(320, 240), kUpright);
  EXPECT_TRUE(percept.line_points.empty() && percept.goal_posts.empty() && percept.obstacles.empty());
  EXPECT_LT(percept.boundary.front(), 120.0f);
}

TEST(HostileImages, OfAnySizeDoNoHarm) {
  FieldFeatures features({}, {});
  for (const auto& [width, height] :
       {std::pair{2, 2}, {2, 480}, {640, 1}, {4, 3}, {16, 16}, {18, 17}, {98, 31}, {1280, 960}, {1024, 7}, {6, 1000}}) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    const Image green = filled(width, height, {75, 105, 108});
    expect_sane(percept_in(features, green.view(), camera_of(width, height), kUpright), width, height);
    const Image random = noise(width, height, 5);
    expect_sane(percept_in(features, random.view(), camera_of(width, height), kUpright), width, height);
    expect_sane(percept_in(features, random.view(), camera_of(640, 480), kUpright), width, height);
  }
}

RC_GTEST_PROP(HostileImages, OfNoiseDoNoHarmInAnyAttitude, ()) {
  const Image image = noise(160, 120, *rc::gen::arbitrary<std::uint64_t>());
  const Image green = filled(160, 120, {75, 105, 108});
  const auto angle = [] { return *rc::gen::inRange(-314, 315) * 0.01; };
  const HeadAngles head{angle(), angle()};
  const TorsoAttitude torso{angle(), angle()};
  const double height = *rc::gen::inRange(-100, 300) * 0.01;
  FieldFeatures features({}, {});
  percept_in(features, green.view(), camera_of(160, 120), kUpright);
  expect_sane(percept_in(features, image.view(), camera_of(160, 120), robot_from_camera({}, head, torso, height)), 160,
              120);
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(HostileImages, OfNoiseShowNoPostsAndFewLines) {
  std::size_t points = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    FieldFeatures features({}, {});
    const Image green = filled(320, 240, {75, 105, 108});
    percept_in(features, green.view(), camera_of(320, 240), kUpright);
    const Image image = noise(320, 240, seed);
    const FieldPercept percept = percept_in(features, image.view(), camera_of(320, 240), kUpright);
    EXPECT_TRUE(percept.goal_posts.empty());
    points += percept.line_points.size();
  }
  EXPECT_LE(points, 10u);
}

TEST(HostileImages, WithAnInvalidCameraPoseShowNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  FieldFeatures features({}, {});
  const Image image = filled(320, 240, {75, 105, 108});
  for (const double bad : {nan, infinite, -infinite}) {
    for (int i = 0; i < 16; ++i) {
      Isometry3 broken = kUpright;
      broken.matrix()(i / 4, i % 4) = bad;
      const FieldPercept percept = percept_in(features, image.view(), camera_of(320, 240), broken);
      EXPECT_TRUE(percept.line_points.empty() && percept.goal_posts.empty() && percept.obstacles.empty());
      EXPECT_EQ(percept.boundary.front(), 240.0f);
    }
    CameraModel camera = camera_of(320, 240);
    camera.focal.x() = bad;
    EXPECT_EQ(percept_in(features, image.view(), camera, kUpright).boundary.front(), 240.0f);
  }
  CameraModel none;
  none.width = none.height = 0;
  EXPECT_EQ(percept_in(features, image.view(), none, kUpright).boundary.front(), 240.0f);
}

}  // namespace
}  // namespace reorient
