// SPDX-License-Identifier: MIT
#include "perception/field/lines/scan_line.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/head.h"
#include "geometry/random.h"
#include "perception/field/ground_projection.h"

namespace reorient {
namespace {

std::vector<std::int16_t> stripe(int length, int begin, int end, std::int16_t dark, std::int16_t bright) {
  std::vector<std::int16_t> luma(static_cast<std::size_t>(length), dark);
  for (int i = begin; i < end; ++i) luma[static_cast<std::size_t>(i)] = bright;
  return luma;
}

RC_GTEST_PROP(ScanLine, FindsAStripeBetweenItsEdges, ()) {
  const int reach = *rc::gen::inRange(1, 5);
  const int begin = *rc::gen::inRange(3 * reach, 40);
  const int width = *rc::gen::inRange(2 * reach, 40);
  const auto luma = stripe(100, begin, begin + width, 100, 300);
  std::vector<BrightSegment> segments;
  find_bright_segments(luma, {20, reach, 40, 60.0}, segments);
  RC_ASSERT(segments.size() == 1u);
  RC_ASSERT(std::abs(segments[0].begin - (begin - 0.5)) < 1e-9);
  RC_ASSERT(std::abs(segments[0].end - (begin + width - 0.5)) < 1e-9);
  RC_ASSERT(segments[0].contrast == 200);
  RC_ASSERT(luma[static_cast<std::size_t>(segments[0].before)] == 100);
  RC_ASSERT(luma[static_cast<std::size_t>(segments[0].after)] == 100);
}

TEST(ScanLine, SkipsStripesThatAreTooLongTooFaintOrTruncated) {
  std::vector<BrightSegment> segments;
  find_bright_segments(stripe(100, 20, 60, 100, 300), {20, 1, 40, 30.0}, segments);
  EXPECT_TRUE(segments.empty());
  find_bright_segments(stripe(100, 20, 30, 100, 130), {20, 1, 40, 30.0}, segments);
  EXPECT_TRUE(segments.empty());
  find_bright_segments(stripe(100, 90, 100, 100, 300), {20, 1, 40, 30.0}, segments);
  EXPECT_TRUE(segments.empty());
  find_bright_segments(stripe(100, 0, 10, 100, 300), {20, 1, 40, 30.0}, segments);
  EXPECT_TRUE(segments.empty());
}

TEST(ScanLine, FindsABlurredStripeInNoiseWithAWiderReach) {
  constexpr int kWidth = 40, kBlur = 20, kBegin = 30;
  Random random(1);
  std::vector<std::int16_t> luma;
  for (int i = 0; i < 100; ++i) {
    const double in = std::clamp(std::min(i - kBegin, kBegin + kWidth - i) / double{kBlur} + 0.5, 0.0, 1.0);
    luma.push_back(static_cast<std::int16_t>(100.0 + 120.0 * in + random.uniform(-6.0, 6.0)));
  }
  std::vector<BrightSegment> segments;
  find_bright_segments(luma, {24, 4, 60, 60.0}, segments);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_NEAR(segments[0].begin, kBegin, 3.0);
  EXPECT_NEAR(segments[0].end, kBegin + kWidth, 3.0);
  find_bright_segments(luma, {24, 1, 60, 60.0}, segments);
  EXPECT_TRUE(segments.empty());
}

TEST(ScanLine, FindsNothingInAShortLine) {
  std::vector<BrightSegment> segments;
  for (int length = 0; length < 8; ++length) {
    find_bright_segments(stripe(length, 0, length, 0, 500), {1, 1, 1, 10.0}, segments);
    EXPECT_TRUE(segments.empty());
    find_bright_segments(stripe(length, 0, length, 0, 500), {1, 4, 1, 10.0}, segments);
    EXPECT_TRUE(segments.empty());
  }
}

RC_GTEST_PROP(GroundProjection, FindsTheGroundPointThatAPixelShows, ()) {
  CameraModel camera = CameraModel::from_fields_of_view(640, 480, 1.0, 0.75);
  camera.k1 = 0.03;
  const HeadAngles head{*rc::gen::inRange(-100, 101) * 0.01, *rc::gen::inRange(-10, 50) * 0.01};
  const TorsoAttitude torso{*rc::gen::inRange(-20, 21) * 0.01, *rc::gen::inRange(-10, 11) * 0.01};
  const auto view = GroundProjection::look(camera, robot_from_camera({}, head, torso, 0.248));
  RC_ASSERT(view.has_value());
  const Eigen::Vector2d pixel(*rc::gen::inRange(0, 640), *rc::gen::inRange(0, 480));
  const auto ground = view->ground(pixel);
  RC_ASSERT(ground.has_value() == (pixel.y() > view->horizon(pixel.x()) + 0.5) ||
            std::abs(pixel.y() - view->horizon(pixel.x())) < 1.5);
  if (!ground) return;
  const auto again = view->pixel({ground->x(), ground->y(), 0.0});
  RC_ASSERT(again.has_value());
  RC_ASSERT((*again - pixel).norm() < 1e-2);
}

/// The same for lenses whose horizon is a curve.
RC_GTEST_PROP(GroundProjection, FindsGroundAndHorizonThroughAWideLens, (bool fisheye)) {
  Lens lens;
  lens.projection = fisheye ? CameraProjection::fisheye : CameraProjection::equirectangular;
  const CameraModel camera = CameraModel::from_fields_of_view(640, 480, from_degrees(160.0), from_degrees(120.0), lens);
  const HeadAngles head{*rc::gen::inRange(-100, 101) * 0.01, *rc::gen::inRange(-10, 50) * 0.01};
  const TorsoAttitude torso{*rc::gen::inRange(-20, 21) * 0.01, *rc::gen::inRange(-10, 11) * 0.01};
  const auto view = GroundProjection::look(camera, robot_from_camera({}, head, torso, 0.248));
  RC_ASSERT(view.has_value());
  const Eigen::Vector2d pixel(*rc::gen::inRange(0, 640), *rc::gen::inRange(0, 480));
  const auto ground = view->ground(pixel);
  constexpr double kStraight = 4.0;  // pixels by which the horizon bends between two of its points
  RC_ASSERT(ground.has_value() == (pixel.y() > view->horizon(pixel.x())) ||
            std::abs(pixel.y() - view->horizon(pixel.x())) < kStraight);
  RC_ASSERT(view->highest_horizon() <= view->horizon(pixel.x()));
  RC_ASSERT(view->pixels_per_radian(pixel) > 100.0);
  RC_ASSERT(std::abs(view->vertical_slant(pixel)) <= 2.0);
  if (!ground) return;
  const auto again = view->pixel({ground->x(), ground->y(), 0.0});
  RC_ASSERT(again.has_value());
  RC_ASSERT((*again - pixel).norm() < 1e-2);
}

}  // namespace
}  // namespace reorient
