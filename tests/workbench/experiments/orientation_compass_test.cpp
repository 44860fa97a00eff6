// SPDX-License-Identifier: MIT
// All compasses in the same situation: a robot in a painted hall that scans with its head.
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/perception/room/painted_room.h"
#include "workbench/experiments/peers/compass_look.h"
#include "workbench/experiments/peers/compass_methods.h"

namespace reorient {
namespace {

using test::PaintedRoom;
using test::ScanningRobot;

constexpr double kStep = 1.0 / 15.0;  // s

std::unique_ptr<OrientationCompass> compass(std::size_t method) {
  CompassParameters parameters;
  parameters.room_paper = test::paper_recipe();
  parameters.transitions.palette = 2.0;
  return std::move(make_compasses(parameters, 1)[method]);
}

/// Rotates at its position, so that it sees the whole room.
class Learner {
 public:
  explicit Learner(const PaintedRoom& room) : robot(room, {}, 3) { robot.truth = robot.belief = Pose2(0.5, 0.3, 0.0); }

  RoomObservation next() {
    robot.time += kStep;
    robot.truth = robot.belief = Pose2(robot.truth.position, robot.truth.rotation + 0.4 * kStep);
    return robot.look();
  }
  void teach(OrientationCompass& compass, double seconds = 20.0) {
    for (int i = 0; i < seconds / kStep; ++i) compass.learn(next());
  }
  /// The evidence against the true pose after some seconds, or against its reflection.
  double ask(OrientationCompass& compass, bool reflected, double seconds = 3.0) {
    compass.begin();
    double score = 0.0;
    for (int i = 0; i < seconds / kStep; ++i) {
      RoomObservation view = next();
      if (reflected) view.belief = reflect(view.belief);
      score = compass.compare(view);
    }
    return score;
  }
  /// Whether its own rule flips the true pose within some seconds, or its reflection.
  bool is_flipped(OrientationCompass& compass, bool reflected) {
    compass.begin();
    for (int i = 0; i < 3.0 / kStep; ++i) {
      RoomObservation view = next();
      if (reflected) view.belief = reflect(view.belief);
      compass.compare(view);
      if (compass.wants_flip() == true) return true;
    }
    return false;
  }

  ScanningRobot robot;
};

class EachCompass : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EachCompass, DistinguishesAPoseFromTheMirroredPose) {
  Learner learner(PaintedRoom::colorful(5));
  const auto learned = compass(GetParam());
  learner.teach(*learned);
  const auto other = learned->clone();
  for (int i = 0; i < 4; ++i) {
    EXPECT_LT(learner.ask(*learned, false), 0.0) << i;
    EXPECT_GT(learner.ask(*other, true), 0.0) << i;
  }
}

TEST_P(EachCompass, HasARuleForFlipsWhereOneIsKnown) {
  Learner learner(PaintedRoom::colorful(5));
  const auto learned = compass(GetParam());
  EXPECT_EQ(learned->wants_flip().has_value(), kHasFlipRule[GetParam()]);
  if (!kHasFlipRule[GetParam()]) return;
  learner.teach(*learned);
  const auto other = learned->clone();
  EXPECT_FALSE(learner.is_flipped(*learned, false));
  // Between plain panels many corners match by chance: corner_landmarks_test.cpp flips with narrow gates.
  if (kCompassMethods[GetParam()] == "corner landmarks") return;
  EXPECT_TRUE(learner.is_flipped(*other, true));
  other->begin();
  EXPECT_EQ(other->wants_flip(), false);
}

TEST_P(EachCompass, HasLittleEvidenceInASymmetricRoom) {
  // Landmarks with an assumed distance support the position where they were learned, even in a symmetric room:
  // corner_landmarks_test.cpp tests in the center of the field.
  if (kCompassMethods[GetParam()] == "corner landmarks") GTEST_SKIP() << "it depends on the place";
  Learner colorful(PaintedRoom::colorful(5)), symmetric(PaintedRoom::symmetric(5));
  const auto in_colorful = compass(GetParam()), in_symmetric = compass(GetParam());
  colorful.teach(*in_colorful);
  symmetric.teach(*in_symmetric);
  double told = 0.0, imagined = 0.0;
  for (int i = 0; i < 4; ++i) {
    told += std::abs(colorful.ask(*in_colorful, false));
    imagined += std::abs(symmetric.ask(*in_symmetric, false));
  }
  // The paper's particles gather on one of the two sides by chance.
  const bool has_particles = kCompassMethods[GetParam()] == "its paper recipe";
  EXPECT_LT(imagined, (has_particles ? 1.0 : 0.35) * told);
}

TEST_P(EachCompass, HasNoEvidenceBeforeItHasLearned) {
  Learner learner(PaintedRoom::colorful(5));
  if (kCompassMethods[GetParam()] == "its paper recipe") GTEST_SKIP() << "its particles always support one pose";
  EXPECT_EQ(learner.ask(*compass(GetParam()), false), 0.0);
}

TEST_P(EachCompass, HasNoEvidenceWithoutAView) {
  Learner learner(PaintedRoom::colorful(5));
  const auto learned = compass(GetParam());
  learner.teach(*learned);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const char* what : {"no image", "a belief that is no number", "a camera that is no number",
                           "a belief outside of the wall", "the floor", "a camera without focal length"}) {
    SCOPED_TRACE(what);
    learned->begin();
    const double before = [&] {
      RoomObservation nowhere = learner.next();
      nowhere.image = {};
      return learned->compare(nowhere);
    }();
    for (int i = 0; i < 5; ++i) {
      RoomObservation view = learner.next();
      const std::string kind = what;
      if (kind == "no image") view.image = {};
      if (kind == "a belief that is no number") view.belief.rotation = nan;
      if (kind == "a camera that is no number") view.robot_from_camera.translation().x() = nan;
      if (kind == "a belief outside of the wall") view.belief.position = {90.0, 0.0};
      if (kind == "the floor") view.robot_from_camera = test::standing_camera(0.0, 1.3);
      if (kind == "a camera without focal length") view.camera.focal.setZero();
      const auto copy = learned->clone();
      copy->learn(view);
      EXPECT_EQ(learned->compare(view), before);
    }
  }
}

TEST_P(EachCompass, IsNotConvincedByADarkImage) {
  Learner learner(PaintedRoom::colorful(5));
  const auto learned = compass(GetParam());
  learner.teach(*learned);
  const auto other = learned->clone();
  Image dark(160, 120);
  for (int y = 0; y < dark.height(); ++y) {
    for (int x = 0; x < 2 * dark.width(); ++x) dark.row(y)[x] = x % 2 == 0 ? 0 : 128;
  }
  learned->begin();
  double score = 0.0;
  for (int i = 0; i < 45; ++i) {
    RoomObservation view = learner.next();
    view.image = dark.view();
    score = learned->compare(view);
    ASSERT_TRUE(std::isfinite(score));
  }
  EXPECT_LT(std::abs(score), std::abs(learner.ask(*other, false)));
}

TEST_P(EachCompass, GivesTheSameBitsForTheSameViews) {
  const auto scores = [&] {
    Learner learner(PaintedRoom::colorful(9));
    const auto learned = compass(GetParam());
    learner.teach(*learned, 10.0);
    const auto copy = learned->clone();
    Learner twin = learner;
    std::vector<double> all{learner.ask(*learned, true), learner.ask(*learned, false)};
    EXPECT_EQ(twin.ask(*copy, true), all[0]);
    EXPECT_EQ(twin.ask(*copy, false), all[1]);
    return all;
  };
  EXPECT_EQ(scores(), scores());
}

INSTANTIATE_TEST_SUITE_P(All, EachCompass, ::testing::Range(std::size_t{0}, kCompassMethods.size()),
                         [](const auto& one) {
                           std::string name(kCompassMethods[one.param]);
                           for (char& letter : name) letter = letter == ' ' ? '_' : letter;
                           return name;
                         });

}  // namespace
}  // namespace reorient
