// SPDX-License-Identifier: MIT
#include "geometry/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/angle.h"

namespace reorient {
namespace {

CameraModel nao_camera() { return CameraModel::from_fields_of_view(640, 480, from_degrees(56.3), from_degrees(43.7)); }

TEST(Camera, SeesAPointOnItsAxisAtThePrincipalPoint) {
  const auto pixel = nao_camera().project({2.0, 0.0, 0.0});
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 319.5, 1e-9);
  EXPECT_NEAR(pixel->y(), 239.5, 1e-9);
}

TEST(Camera, SeesLeftPointsOnTheLeftAndHighPointsAtTheTop) {
  const auto pixel = nao_camera().project({2.0, 0.5, 0.5});
  ASSERT_TRUE(pixel);
  EXPECT_LT(pixel->x(), 319.5);
  EXPECT_LT(pixel->y(), 239.5);
}

TEST(Camera, DoesNotSeeWhatIsBehindIt) { EXPECT_FALSE(nao_camera().project({-1.0, 0.0, 0.0})); }

TEST(Camera, DoesNotProjectWhereTheDistortionFoldsBack) {
  CameraModel camera = nao_camera();
  camera.k1 = -0.3;
  EXPECT_FALSE(camera.project({1.0, 2.0, 0.0}));
}

TEST(Camera, HasTheGivenFieldsOfView) { EXPECT_NEAR(to_degrees(nao_camera().horizontal_field_of_view()), 56.3, 1e-6); }

TEST(Camera, ScaledDownHasTheSameFieldOfView) {
  const CameraModel half = nao_camera().scaled_to(320, 240);
  EXPECT_NEAR(half.horizontal_field_of_view(), nao_camera().horizontal_field_of_view(), 1e-9);
  EXPECT_NEAR(half.center.x(), 159.5, 1e-9);
}

RC_GTEST_PROP(Camera, ProjectsTheRayOfAPixelToThatPixel, ()) {
  CameraModel camera = nao_camera();
  camera.k1 = *rc::gen::inRange(-250, 250) * 1e-3;
  camera.k2 = *rc::gen::inRange(-50, 50) * 1e-3;
  const Eigen::Vector2d pixel(*rc::gen::inRange(0, 640), *rc::gen::inRange(0, 480));
  const auto again = camera.project(7.0 * camera.ray(pixel));
  RC_ASSERT(again.has_value());
  RC_ASSERT((*again - pixel).norm() < 1e-5);
}

TEST(Camera, HasFiniteRaysWhateverTheDistortion) {
  for (const double k1 : {-1e300, -1e3, -0.9, 0.0, 0.9, 1e3, 1e300}) {
    for (const double k2 : {-1e300, -0.9, 0.0, 0.9, 1e300}) {
      CameraModel camera = nao_camera();
      camera.k1 = k1;
      camera.k2 = k2;
      for (const Eigen::Vector2d& pixel :
           {Eigen::Vector2d(319.5, 239.5), Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(639.0, 300.0)})
        EXPECT_TRUE(camera.ray(pixel).allFinite()) << k1 << " " << k2;
    }
  }
}

}  // namespace
}  // namespace reorient
