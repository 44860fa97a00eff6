// SPDX-License-Identifier: MIT
// Corner landmarks: corners of drawn images, their descriptors, the map of them, and when the pose is flipped.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/perception/room/painted_room.h"
#include "workbench/experiments/peers/corner_compass.h"

namespace reorient {
namespace {

using Paint = std::function<int(int x, int y)>;

Image drawn(int width, int height, const Paint& luma) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.row(y)[2 * x] = static_cast<std::uint8_t>(std::clamp(luma(x, y), 0, 255));
      image.row(y)[2 * x + 1] = 128;
    }
  }
  return image;
}

std::vector<Corner> corners_in(const Image& image, int contrast = 20) {
  return find_corners(LumaPlane(image.view()), image.height(), contrast);
}

/// Random bright spots, the same on every machine.
int texture(int x, int y) {
  int luma = 128;
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const int center_x = static_cast<int>(random.below(96)), center_y = static_cast<int>(random.below(96));
    const int strength = static_cast<int>(random.below(121)) - 60;
    if (std::abs(x - center_x) <= 6 && std::abs(y - center_y) <= 6) luma += strength;
  }
  return luma;
}

TEST(FindCorners, FindsTheFourCornersOfASquare) {
  const auto corners =
      corners_in(drawn(96, 96, [](int x, int y) { return x >= 30 && x < 60 && y >= 32 && y < 64 ? 200 : 60; }));
  ASSERT_EQ(corners.size(), 4U);
  for (const auto& [x, y] : {std::pair(30, 32), std::pair(59, 32), std::pair(30, 63), std::pair(59, 63)}) {
    EXPECT_TRUE(std::any_of(
        corners.begin(), corners.end(),
        [x = x, y = y](const Corner& corner) { return std::abs(corner.x - x) <= 2 && std::abs(corner.y - y) <= 2; }))
        << x << ", " << y;
  }
}

TEST(FindCorners, FindsDarkCornersAsWellAsBrightOnes) {
  const auto corners =
      corners_in(drawn(96, 96, [](int x, int y) { return x >= 30 && x < 60 && y >= 32 && y < 64 ? 60 : 200; }));
  EXPECT_EQ(corners.size(), 4U);
}

TEST(FindCorners, FindsNoneOnEdgesAndOnEvenGround) {
  EXPECT_TRUE(corners_in(drawn(96, 96, [](int, int) { return 90; })).empty());
  EXPECT_TRUE(corners_in(drawn(96, 96, [](int x, int) { return x < 48 ? 40 : 200; })).empty());
  EXPECT_TRUE(corners_in(drawn(96, 96, [](int, int y) { return y < 48 ? 200 : 40; })).empty());
  EXPECT_TRUE(corners_in(drawn(96, 96, [](int x, int y) { return x + y < 96 ? 40 : 200; })).empty());
  EXPECT_TRUE(corners_in(drawn(96, 96, [](int x, int y) { return 2 * x < y ? 40 : 200; })).empty());
  EXPECT_TRUE(corners_in(drawn(96, 96, [](int x, int y) { return x + y; })).empty());
}

TEST(FindCorners, FindsACornerUpToItsContrastAndNotBeyond) {
  const Image image = drawn(96, 96, [](int x, int y) { return x >= 48 && y >= 48 ? 100 : 70; });
  const auto corners = corners_in(image, 29);
  ASSERT_EQ(corners.size(), 1U);
  EXPECT_EQ(corners[0].score, 29);
  EXPECT_TRUE(corners_in(image, 30).empty());
}

TEST(FindCorners, ReturnsNoTwoCornersSideBySide) {
  const auto corners = corners_in(drawn(96, 96, texture), 5);
  ASSERT_GE(corners.size(), 20U);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(std::max(std::abs(corners[i].x - corners[j].x), std::abs(corners[i].y - corners[j].y)), 1);
    }
  }
}

TEST(FindCorners, SearchesOnlyTheGivenRowsWithinItsMargin) {
  const Image image = drawn(96, 96, texture);
  for (const Corner& corner : find_corners(LumaPlane(image.view()), 50, 5)) {
    EXPECT_LT(corner.y, 50);
    EXPECT_GE(std::min(corner.x, corner.y), kCornerMargin);
    EXPECT_LT(corner.x, 96 - kCornerMargin);
  }
  EXPECT_TRUE(find_corners(LumaPlane(image.view()), kCornerMargin, 5).empty());
  EXPECT_TRUE(find_corners(LumaPlane(image.view()), -7, 5).empty());
  EXPECT_TRUE(find_corners(LumaPlane(ImageView{}), 50, 5).empty());
  for (const int size : {2, 34, 36}) EXPECT_TRUE(corners_in(drawn(size, size, texture), 5).empty()) << size;
}

TEST(CornerDescriptor, IsTheSameAfterARotationOfTheImageBy90Degrees) {
  constexpr int kMiddle = 48;
  const Corner corner{kMiddle, kMiddle, 1};
  const LumaPlane upright(drawn(97 + 1, 97, texture).view());
  const Image image = drawn(97 + 1, 97, [](int x, int y) { return texture(y, 2 * kMiddle - x); });
  const LumaPlane turned(image.view());
  const CornerDescriber one(upright, 97), other(turned, 97);
  EXPECT_EQ(other.direction_of(corner), (one.direction_of(corner) + 8) % 32);
  EXPECT_EQ(distance(one.describe(corner), other.describe(corner)), 0);
}

TEST(CornerDescriptor, ChangesLittleWithBrightnessAndNoiseButMuchBetweenPlaces) {
  Random random(5);
  const LumaPlane image(drawn(96, 96, texture).view());
  const LumaPlane dim(
      drawn(96, 96, [&](int x, int y) { return texture(x, y) / 2 + static_cast<int>(random.below(5)) - 2; }).view());
  const CornerDescriber describer(image, 96), of_dim(dim, 96);
  const auto corners = find_corners(image, 96, 20);
  ASSERT_GE(corners.size(), 5U);
  int same = 0, different = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    same += distance(describer.describe(corners[i]), of_dim.describe(corners[i])) <= 40 ? 1 : 0;
    const Corner& far = corners[(i + corners.size() / 2) % corners.size()];
    different += distance(describer.describe(corners[i]), describer.describe(far)) > 64 ? 1 : 0;
  }
  EXPECT_GE(same, static_cast<int>(0.9 * static_cast<double>(corners.size())));
  EXPECT_GE(different, static_cast<int>(0.8 * static_cast<double>(corners.size())));
}

TEST(CornerDescriptor, IsTheSameOnEveryProcessor) {
  const LumaPlane image(drawn(96, 96, texture).view());
  const CornerDescriber describer(image, 96);
  std::uint64_t sum = 0;
  for (const Corner& corner : find_corners(image, 96, 10)) {
    sum = scatter(sum ^ static_cast<std::uint64_t>(corner.x * 1000 + corner.y));
    for (const std::uint64_t word : describer.describe(corner)) sum = scatter(sum ^ word);
  }
  EXPECT_EQ(sum, 16632155889358853826ULL)
      << "the features of an image have changed; update this number only on purpose";
}

TEST(CornerDescriptor, HasNoDirectionInAnEvenPatch) {
  const LumaPlane even(drawn(64, 64, [](int, int) { return 70; }).view());
  const CornerDescriber describer(even, 64);
  EXPECT_EQ(describer.direction_of({32, 32, 1}), 0);
  EXPECT_EQ(describer.describe({32, 32, 1}), CornerDescriptor{});
}

/// A robot at a fixed position in a painted room that rotates and scans with its head.
class TurningRobot {
 public:
  TurningRobot(const test::PaintedRoom& room, const Pose2& pose) : robot_(room, {}, 3) {
    robot_.truth = robot_.belief = pose;
  }

  RoomObservation next() {
    constexpr double kStep = 1.0 / 15.0;  // s
    robot_.time += kStep;
    robot_.truth = robot_.belief = Pose2(robot_.truth.position, robot_.truth.rotation + 0.4 * kStep);
    return robot_.look();
  }
  void teach(CornerCompass& compass, int frames = 300) {
    for (int i = 0; i < frames; ++i) compass.learn(next());
  }
  double ask(CornerCompass& compass, bool mirrored, int frames) {
    double score = 0.0;
    for (int i = 0; i < frames; ++i) {
      RoomObservation view = next();
      if (mirrored) view.belief = reflect(view.belief);
      score = compass.compare(view);
    }
    return score;
  }
  /// 0: not within 200 frames.
  int frames_until_flip(CornerCompass& compass, bool mirrored) {
    for (int frames = 1; frames <= 200; ++frames) {
      ask(compass, mirrored, 1);
      if (compass.wants_flip() == true) return frames;
    }
    return 0;
  }

 private:
  test::ScanningRobot robot_;
};

/// With narrow gates: corners between plain panels resemble each other, and wide gates would find so many chance
/// matches that neither pose has twice as many as the other.
CornerCompassParameters narrow_gates() {
  CornerCompassParameters parameters;
  parameters.contrast = 20;
  parameters.map.gate_angle = 0.1;
  parameters.map.angle_deviation = 0.04;
  parameters.map.gate_bits = 64;
  parameters.map.bits_deviation = 32.0;
  parameters.map.gain = 3.0;
  return parameters;
}

TEST(CornerCompass, PrefersTheMirroredPoseIfTheBeliefIsMirrored) {
  TurningRobot learner(test::PaintedRoom::colorful(5), {0.5, 0.3, 0.0});
  CornerCompass right(narrow_gates());
  learner.teach(right);
  CornerCompass mirrored = right;
  EXPECT_LT(learner.ask(right, false, 45), -20.0);
  EXPECT_GT(learner.ask(mirrored, true, 45), 20.0);
  EXPECT_EQ(learner.frames_until_flip(right, false), 0);
  EXPECT_GE(learner.frames_until_flip(mirrored, true), 1);
}

TEST(CornerCompass, HasLittleEvidenceInASymmetricRoom) {
  // In the center of the field, where a pose and its mirrored pose have the same position: elsewhere the assumed
  // distance of the landmarks alone supports the position where they were learned.
  TurningRobot learner(test::PaintedRoom::symmetric(5), {0.0, 0.0, 0.0});
  CornerCompass compass;
  learner.teach(compass, 600);
  for (int i = 0; i < 4; ++i) {
    compass.begin();
    EXPECT_LT(std::abs(learner.ask(compass, false, 45)), 20.0);
    EXPECT_EQ(compass.wants_flip(), false);
  }
}

TEST(CornerCompass, FollowsAMapThatWasLearnedMirrored) {
  TurningRobot learner(test::PaintedRoom::colorful(5), {0.5, 0.3, 0.0});
  CornerCompass compass;
  for (int i = 0; i < 300; ++i) {
    RoomObservation view = learner.next();
    view.belief = reflect(view.belief);
    compass.learn(view);
  }
  EXPECT_LT(learner.ask(compass, true, 45), -20.0) << "the mirrored belief fits the map";
  compass.begin();
  EXPECT_GT(learner.ask(compass, false, 45), 20.0);
}

TEST(CornerCompass, FlipsLateAfterALongTimeOfRightPoses) {
  TurningRobot learner(test::PaintedRoom::colorful(5), {0.5, 0.3, 0.0});
  CornerCompass compass(narrow_gates());
  learner.teach(compass);
  EXPECT_EQ(learner.ask(compass, false, 150), -40.0);
  // From 40 to -25 with forgetting, at most 6 a frame, it takes 11 frames, of which the last is the first of 10.
  EXPECT_GE(learner.frames_until_flip(compass, true), 11 + 9);
}

CornerView view_of(const RoomObservation& view) { return *CornerView::of(view, 20, 100); }

TEST(CornerMap, RemovesLandmarksThatAreNotSeenAgain) {
  const Image image = drawn(160, 120, [](int x, int y) { return texture(x % 96, y); });
  const Image blank = drawn(160, 120, [](int, int) { return 128; });
  RoomObservation view;
  view.camera = test::small_camera();
  view.robot_from_camera = test::standing_camera(0.0, -0.2);
  view.image = image.view();
  CornerMap map({});
  for (int i = 0; i < 10; ++i) map.learn(view_of(view));
  const int learned = map.size();
  EXPECT_GE(learned, 3);
  RoomObservation away = view;
  away.image = blank.view();
  away.robot_from_camera = test::standing_camera(2.0, -0.2);
  for (int i = 0; i < 200; ++i) map.learn(view_of(away));
  EXPECT_EQ(map.size(), learned) << "they are not in view";
  const std::vector<CoveredArea> robot{{0, 0, 159, 119}};
  away.robot_from_camera = view.robot_from_camera;
  away.covered = robot;
  for (int i = 0; i < 200; ++i) map.learn(view_of(away));
  EXPECT_EQ(map.size(), learned) << "a robot hides them";
  away.covered = {};
  for (int i = 0; i < 200; ++i) map.learn(view_of(away));
  EXPECT_LE(map.size(), learned / 3) << "one at the border of the searched part may stay";
}

TEST(CornerMap, HasAtMostTheLargestNumberOfLandmarks) {
  CornerMapParameters parameters;
  parameters.landmarks = 40;
  parameters.gate_bits = 0;  // hardly anything is seen again
  CornerMap map(parameters);
  TurningRobot learner(test::PaintedRoom::colorful(5), {0.5, 0.3, 0.0});
  for (int i = 0; i < 200; ++i) {
    map.learn(view_of(learner.next()));
    ASSERT_LE(map.size(), 40);
  }
  EXPECT_GE(map.size(), 20);
}

TEST(CornerMap, CoversDirectionsThatItHasSeenOften) {
  CornerMap map({});
  EXPECT_EQ(map.coverage(), 0.0);
  TurningRobot learner(test::PaintedRoom::colorful(5), {0.5, 0.3, 0.0});
  map.learn(view_of(learner.next()));
  EXPECT_EQ(map.coverage(), 0.0) << "one frame is not enough";
  for (int i = 0; i < 300; ++i) map.learn(view_of(learner.next()));
  EXPECT_GE(map.coverage(), 0.8);
}

TEST(CornerView, LeavesOutCornersBelowTheHorizonOrCovered) {
  const Image image = drawn(160, 120, [](int x, int y) { return texture(x % 96, y % 96); });
  RoomObservation view;
  view.image = image.view();
  view.camera = test::small_camera();
  view.robot_from_camera = test::standing_camera(0.3);
  view.belief = Pose2(-1.0, 0.5, 2.0);
  const CornerView seen = view_of(view);
  ASSERT_GE(seen.corners().size(), 3U);
  for (const SeenCorner& corner : seen.corners()) {
    EXPECT_GT(corner.ray.z(), 0.0);
    EXPECT_TRUE(seen.shows(seen.eye() + 6.0 * corner.ray));
    EXPECT_FALSE(seen.shows(seen.eye() - 6.0 * corner.ray));
  }
  EXPECT_LE(CornerView::of(view, 20, 2)->corners().size(), 2U);
  const std::vector<CoveredArea> all{{0, 0, 159, 119}};
  view.covered = all;
  EXPECT_TRUE(view_of(view).corners().empty());
}

constexpr CornerFit kNothing{0, 0.0};

TEST(CornerDecision, LimitsEachFrameAndTheTotalAndForgets) {
  CornerDecision decision({});
  decision.update({50, 1000.0}, kNothing, 1.0);
  EXPECT_EQ(decision.ratio(), 6.0);
  decision.update({50, 1000.0}, kNothing, 1.0);
  EXPECT_DOUBLE_EQ(decision.ratio(), 0.98 * 6.0 + 6.0);
  for (int i = 0; i < 100; ++i) decision.update({50, 1000.0}, kNothing, 1.0);
  EXPECT_EQ(decision.ratio(), 40.0);
  decision.update(kNothing, kNothing, 1.0);
  EXPECT_DOUBLE_EQ(decision.ratio(), 0.98 * 40.0);
  for (int i = 0; i < 100; ++i) decision.update(kNothing, {50, 1000.0}, 0.0);
  EXPECT_EQ(decision.ratio(), -40.0);
  decision.restart();
  EXPECT_EQ(decision.ratio(), 0.0);
}

/// Number of frames until the pose is flipped; 0: not within 100 frames.
int frames_until_flip(const CornerFit& believed, const CornerFit& mirrored, double coverage) {
  CornerDecision decision({});
  for (int frame = 1; frame <= 100; ++frame) {
    decision.update(believed, mirrored, coverage);
    if (decision.wants_flip()) return frame;
  }
  return 0;
}

TEST(CornerDecision, FlipsOnceAllConditionsHaveHeldForTenFrames) {
  // 6 a frame with forgetting: 27.2 after the fifth frame, which is the first of ten.
  EXPECT_EQ(frames_until_flip(kNothing, {3, 9.0}, 0.5), 14);
  EXPECT_EQ(frames_until_flip({3, 0.0}, {6, 9.0}, 0.5), 14);
  EXPECT_EQ(frames_until_flip(kNothing, {2, 9.0}, 0.5), 0) << "too few matches";
  EXPECT_EQ(frames_until_flip({4, 0.0}, {7, 9.0}, 0.5), 0) << "not twice as many";
  EXPECT_EQ(frames_until_flip(kNothing, {3, 9.0}, 0.49), 0) << "too little coverage";
  EXPECT_EQ(frames_until_flip(kNothing, {3, 0.4}, 0.5), 0) << "0.4 a frame never adds up to 25";
  EXPECT_EQ(frames_until_flip({3, 9.0}, kNothing, 1.0), 0) << "the believed pose fits";
}

TEST(CornerDecision, StartsToCountAgainAfterAFrameInWhichAConditionFails) {
  CornerDecision decision({});
  for (int i = 0; i < 13; ++i) decision.update(kNothing, {3, 9.0}, 1.0);
  EXPECT_FALSE(decision.wants_flip());
  decision.update(kNothing, {2, 9.0}, 1.0);
  for (int i = 0; i < 9; ++i) {
    decision.update(kNothing, {3, 9.0}, 1.0);
    EXPECT_FALSE(decision.wants_flip()) << i;
  }
  decision.update(kNothing, {3, 9.0}, 1.0);
  EXPECT_TRUE(decision.wants_flip());
}

}  // namespace
}  // namespace reorient
