// SPDX-License-Identifier: MIT
// Lens models: projection and ray agree over the whole image, and with the numbers of OpenCV.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/angle.h"
#include "geometry/bytes.h"
#include "geometry/camera.h"

namespace reorient {
namespace {

double between(double least, double most) { return least + (most - least) * *rc::gen::inRange(0, 10001) * 1e-4; }

CameraModel camera_with(CameraProjection projection, const std::vector<double>& coefficients, double focal = 310.0) {
  CameraModel camera;
  camera.width = 544;
  camera.height = 448;
  camera.focal = {focal, focal};
  camera.center = {271.5, 223.5};
  camera.projection = projection;
  EXPECT_EQ(camera.set_coefficients(coefficients), "");
  return camera;
}

/// Typical principal point and aspect of a calibration.
void vary(CameraModel& camera) {
  camera.focal.y() *= between(0.98, 1.02);
  camera.center += Eigen::Vector2d(between(-15.0, 15.0), between(-15.0, 15.0));
}

void expect_agreement(const CameraModel& camera) {
  RC_ASSERT(mistake_in(camera) == "");
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector2d pixel(between(-0.5, camera.width - 0.5), between(-0.5, camera.height - 0.5));
    const Eigen::Vector3d ray = camera.ray(pixel);
    const auto again = camera.project(between(0.1, 20.0) * ray);
    RC_ASSERT(again.has_value());
    RC_ASSERT((*again - pixel).norm() < 0.01);
    RC_ASSERT((camera.is_perspective() ? ray.x() == 1.0 : std::abs(ray.norm() - 1.0) < 1e-12));
  }
}

RC_GTEST_PROP(Lens, WithFiveCoefficientsProjectsARayToItsPixel, ()) {
  const double k1 = between(-0.3, 0.1);
  CameraModel camera = camera_with(
      CameraProjection::pinhole,
      {k1, k1 * k1 + between(0.0, 0.1), between(-0.003, 0.003), between(-0.003, 0.003), between(-0.01, 0.01)}, 400.0);
  vary(camera);
  expect_agreement(camera);
}

RC_GTEST_PROP(Lens, WithEightCoefficientsProjectsARayToItsPixel, ()) {
  const double k4 = between(0.2, 3.0), k5 = between(0.0, 1.5), k6 = between(0.0, 0.3);
  CameraModel camera = camera_with(CameraProjection::pinhole,
                                   {k4 + between(-0.25, 0.0), 0.5 * k5 + between(0.02, 0.3), between(-0.003, 0.003),
                                    between(-0.003, 0.003), 0.3 * k6 + between(0.0, 0.05), k4, k5, k6},
                                   460.0);
  vary(camera);
  expect_agreement(camera);
}

RC_GTEST_PROP(Lens, OfAFisheyeProjectsARayToItsPixelEvenBeyond90Degrees, ()) {
  const double span = between(100.0, 200.0);
  Lens lens;
  lens.projection = CameraProjection::fisheye;
  ASSERT_EQ(lens.set_coefficients(std::vector<double>{between(-0.04, 0.04), between(-0.006, 0.006),
                                                      between(-0.002, 0.002), between(-0.0003, 0.0003)}),
            "");
  CameraModel camera =
      CameraModel::from_fields_of_view(544, 448, from_degrees(span), from_degrees(span * 448 / 544), lens);
  vary(camera);
  RC_PRE(mistake_in(camera) == "");
  expect_agreement(camera);
}

RC_GTEST_PROP(Lens, OfAnEquirectangularCropProjectsARayToItsPixel, ()) {
  CameraModel camera = camera_with(CameraProjection::equirectangular, {}, between(160.0, 600.0));
  vary(camera);
  expect_agreement(camera);
}

struct Golden {
  Eigen::Vector3d point;  // OpenCV's camera frame: x right, y down, z ahead
  Eigen::Vector2d pixel;
};

void expect_golden(CameraProjection projection, const std::vector<double>& coefficients,
                   const std::vector<Golden>& values) {
  CameraModel camera = camera_with(projection, coefficients);
  camera.focal = {310.5, 308.25};
  camera.center = {271.25, 223.75};
  for (const Golden& golden : values) {
    const Eigen::Vector3d point(golden.point.z(), -golden.point.x(), -golden.point.y());
    const auto pixel = camera.project(point);
    ASSERT_TRUE(pixel) << golden.point.transpose();
    EXPECT_LT((*pixel - golden.pixel).norm(), 1e-6) << golden.point.transpose();
    EXPECT_LT((camera.ray(golden.pixel).normalized() - point.normalized()).norm(), 1e-8) << golden.point.transpose();
  }
}

// Values of OpenCV 4.6.0, cv::projectPoints and cv::fisheye::projectPoints.
TEST(Lens, WithFiveCoefficientsMatchesOpenCv) {
  expect_golden(CameraProjection::pinhole, {-0.32, 0.11, 0.0012, -0.0008, -0.017},
                {{{0, 0, 2}, {271.25, 223.75}},
                 {{1, 0, 2}, {414.91980546874998, 223.84247500000001}},
                 {{0, 1, 2}, {271.18790000000001, 366.84109492187497}},
                 {{-0.8, 0.6, 1}, {78.312751999999989, 367.58931399999994}},
                 {{0.5, -0.9, 1.5}, {361.16841234330866, 63.034853838696279}},
                 {{1.2, 1.1, 1.4}, {464.38043656948167, 400.30911098910872}},
                 {{-2, 0.3, 2.5}, {63.797087551820596, 254.86030087508757}},
                 {{0.01, -0.02, 0.5}, {277.45473665155544, 211.43020381647688}}});
}

TEST(Lens, WithEightCoefficientsMatchesOpenCv) {
  expect_golden(CameraProjection::pinhole, {2.3, 0.7, -0.0009, 0.0006, 0.04, 2.65, 1.35, 0.21},
                {{{0, 0, 2}, {271.25, 223.75}},
                 {{1, 0, 2}, {415.03859563655033, 223.68064375}},
                 {{0, 1, 2}, {271.29657500000002, 366.14986804135793}},
                 {{-0.8, 0.6, 1}, {79.325761527831077, 366.51139984069096}},
                 {{0.5, -0.9, 1.5}, {361.82489092123467, 61.922747562489405}},
                 {{1.2, 1.1, 1.4}, {464.35614026844644, 398.87694050044229}},
                 {{-2, 0.3, 2.5}, {64.16156234458785, 254.42477729242552}},
                 {{0.01, -0.02, 0.5}, {277.45662863167848, 211.42687882623255}}});
}

TEST(Lens, OfAFisheyeMatchesOpenCv) {
  expect_golden(CameraProjection::fisheye, {-0.021, 0.0045, -0.0031, 0.00042},
                {{{0, 0, 2}, {271.25, 223.75}},
                 {{1, 0, 2}, {414.58831804340446, 223.75}},
                 {{0, 1, 2}, {271.25, 366.04963457932183}},
                 {{-0.8, 0.6, 1}, {78.480338874140187, 367.27958464262383}},
                 {{0.5, -0.9, 1.5}, {361.30652796549856, 62.822900026869945}},
                 {{1.2, 1.1, 1.4}, {465.41092894482159, 400.44113521729844}},
                 {{-2, 0.3, 2.5}, {64.280475481608278, 254.57046180328223}},
                 {{0.01, -0.02, 0.5}, {277.45560477283703, 211.42872675538152}},
                 {{5.5, 0.4, 1}, {684.74236547773762, 253.60425774463772}},
                 {{-3, -4, 0.5}, {9.9455258750356847, -122.13128459053252}}});
}

TEST(Lens, WithTwoCoefficientsIsTheSameByBothFormulas) {
  CameraModel plain = camera_with(CameraProjection::pinhole, {-0.12, 0.03});
  CameraModel other = plain;
  other.p1 = 1e-300;  // no longer plain
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(3, 7), Eigen::Vector2d(270, 223), Eigen::Vector2d(540, 440)}) {
    EXPECT_LT((plain.ray(pixel) - other.ray(pixel)).norm(), 1e-12);
    EXPECT_LT((*plain.project(plain.ray(pixel)) - *other.project(plain.ray(pixel))).norm(), 1e-9);
  }
}

TEST(Lens, OfAFisheyeSeesBehindItself) {
  Lens lens;
  lens.projection = CameraProjection::fisheye;
  const CameraModel camera = CameraModel::from_fields_of_view(400, 400, from_degrees(200.0), from_degrees(200.0), lens);
  EXPECT_NEAR(to_degrees(camera.horizontal_field_of_view()), 200.0, 1e-9);
  EXPECT_LT(camera.ray({0.0, 199.5}).x(), 0.0);
  const auto pixel = camera.project({-0.1, 1.0, 0.0});
  ASSERT_TRUE(pixel);
  EXPECT_LT(pixel->x(), 10.0);
}

TEST(Lens, ScalesWithTheImage) {
  CameraModel camera = camera_with(CameraProjection::fisheye, {0.01, -0.002, 0.0, 0.0}, 190.0);
  const CameraModel half = camera.scaled_to(272, 224);
  EXPECT_LT((half.ray({10.0, 20.0}) - camera.ray({20.5, 40.5})).norm(), 1e-12);
}

TEST(Lens, AcceptsOnlyTheNumbersOfCoefficientsOfItsProjection) {
  Lens lens;
  for (const std::size_t count : {1u, 3u, 6u, 7u, 9u})
    EXPECT_NE(lens.set_coefficients(std::vector<double>(count, 0.0)).find("0, 2, 4, 5 or 8 coefficients"),
              std::string::npos);
  lens.projection = CameraProjection::fisheye;
  EXPECT_NE(
      lens.set_coefficients(std::vector<double>(5, 0.0)).find("0 or 4 coefficients for a fisheye camera, found 5"),
      std::string::npos);
  lens.projection = CameraProjection::equirectangular;
  EXPECT_NE(lens.set_coefficients(std::vector<double>(2, 0.0)), "");
  for (const CameraProjection each :
       {CameraProjection::pinhole, CameraProjection::fisheye, CameraProjection::equirectangular})
    EXPECT_EQ(projection_named(to_string(each)), each);
  EXPECT_FALSE(projection_named("cylinder"));
}

TEST(Lens, WithHostileNumbersIsRefusedAndNeverCrashes) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
  std::vector<CameraModel> cameras;
  for (const CameraProjection projection :
       {CameraProjection::pinhole, CameraProjection::fisheye, CameraProjection::equirectangular}) {
    for (const double bad : {nan, huge, -huge, std::numeric_limits<double>::infinity()}) {
      for (double Lens::*const which : {&Lens::k1, &Lens::k2, &Lens::k3, &Lens::k4, &Lens::k6, &Lens::p1, &Lens::p2}) {
        CameraModel camera = camera_with(projection, {});
        camera.p2 = 1e-3;
        camera.*which = bad;
        cameras.push_back(camera);
      }
    }
    for (const double focal : {0.0, -100.0, nan}) {
      CameraModel camera = camera_with(projection, {});
      camera.k3 = 1e-3;
      camera.focal.y() = focal;
      EXPECT_NE(mistake_in(camera), "");
      cameras.push_back(camera);
    }
  }
  CameraModel folded = camera_with(CameraProjection::pinhole, {-0.9, 0.0, 0.0, 0.0, 0.0});
  EXPECT_NE(mistake_in(folded).find("the distortion folds back"), std::string::npos);
  folded.p1 = 1e-4;
  EXPECT_NE(mistake_in(folded).find("the distortion folds back"), std::string::npos);
  EXPECT_NE(mistake_in(camera_with(CameraProjection::fisheye, {-0.5, 0.0, 0.0, 0.0}, 190.0)), "");
  EXPECT_NE(mistake_in(camera_with(CameraProjection::fisheye, {}, 60.0)), "") << "more than 360 degrees in the corners";
  EXPECT_NE(mistake_in(camera_with(CameraProjection::equirectangular, {}, 60.0)), "") << "more than 360 degrees";
  cameras.push_back(folded);
  for (const CameraModel& camera : cameras) {
    for (const double u : {0.0, 271.5, 543.0, 1e9, -1e300, nan}) {
      const Eigen::Vector3d ray = camera.ray({u, 100.0});
      static_cast<void>(camera.project(ray));
      static_cast<void>(camera.project({u, 1.0, -1.0}));
    }
    static_cast<void>(camera.project({0.0, 0.0, 0.0}));
    static_cast<void>(mistake_in(camera));
  }
}

TEST(Lens, ThatIsPlainIsWrittenInTheOldFormat) {
  CameraModel camera = camera_with(CameraProjection::pinhole, {0.03, -0.01});
  std::vector<std::byte> bytes, as_before;
  ByteWriter{bytes}(camera);
  ByteWriter{as_before}(camera.width, camera.height, camera.focal, camera.center, camera.k1, camera.k2);
  EXPECT_EQ(bytes, as_before);
}

TEST(Lens, ReadsBackAnyCamera) {
  CameraModel camera = camera_with(CameraProjection::pinhole, {0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.7, -0.8});
  for (const CameraModel& one : {camera, camera_with(CameraProjection::fisheye, {0.1, 0.2, 0.3, 0.4}),
                                 camera_with(CameraProjection::equirectangular, {}), CameraModel()}) {
    std::vector<std::byte> bytes;
    ByteWriter{bytes}(one);
    CameraModel again = camera;
    ByteReader in(bytes);
    in(again);
    in.finish();
    EXPECT_EQ(again, one);
  }
}

}  // namespace
}  // namespace reorient
