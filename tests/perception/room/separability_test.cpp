// SPDX-License-Identifier: MIT
// Tests whether a room looks the same after a rotation by 180 degrees.
#include "perception/room/separability.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/bytes.h"
#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

using test::PaintedRoom;
using test::ScanningRobot;

/// A robot that has seen the whole room from one known pose.
ScanningRobot scanned(const PaintedRoom& room, const RoomParameters& parameters = {}) {
  ScanningRobot robot(room, parameters, 1);
  for (int quarter = 0; quarter < 4; ++quarter) {  // the head alone does not reach all walls
    robot.run(4.0);
    robot.truth.rotation += kPi / 2;
    robot.belief = robot.truth;
  }
  return robot;
}

/// A wall of known tiles, each with a fraction of black; the rest is white.
class KnownWall {
 public:
  explicit KnownWall(int columns, double (*black_at)(double turns)) : wall({8.0, 0.7, 3.1, 2, columns}) {
    TrainingStep how;
    how.step = 1.0;
    model_.forget(wall.tiles());
    for (int tile = 0; tile < wall.tiles(); ++tile) {
      ColorHistogram histogram{};
      histogram[0] = static_cast<float>(black_at((wall.column_of(tile) + 0.5) / columns));
      histogram[1] = 1.0f - histogram[0];
      model_.train(tile, histogram, how);
    }
    compared.prepare(model_, wall, Comparison{});
    separability.restart(columns);
  }

  double probability() {
    for (int column = 0; column < wall.columns(); ++column) separability.observe(compared, wall);
    return separability.probability();
  }

  Wall wall;
  ComparedModel compared;
  Separability separability;

 private:
  BackgroundModel model_;
};

double one_wave(double turns) { return 0.5 + 0.4 * std::sin(2.0 * kPi * turns); }
double two_waves(double turns) { return 0.5 + 0.4 * std::sin(4.0 * kPi * turns); }
double four_waves(double turns) { return 0.5 + 0.4 * std::sin(8.0 * kPi * turns); }
double gray(double) { return 0.5; }

constexpr double kUnknown = 0.756;  // the value from experience

TEST(Separability, IsAlmostCertainInARoomWithoutRepetition) {
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_GT(scanned(PaintedRoom::colorful(seed)).awareness.confidences().separability, 0.95) << seed;
}

TEST(Separability, IsImprobableInASymmetricRoomWhichThenGivesNoEvidence) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    ScanningRobot robot = scanned(PaintedRoom::symmetric(seed));
    EXPECT_LT(robot.awareness.confidences().separability, 0.1) << seed;
    robot.run(2.0);
    EXPECT_EQ(robot.awareness.confidences().evidence, 0.0) << seed;
  }
}

TEST(Separability, DoesNotScaleTheEvidenceIfDisabled) {
  RoomParameters parameters;
  parameters.evidence.use_separability = false;
  ScanningRobot without = scanned(PaintedRoom::symmetric(1), parameters), with = scanned(PaintedRoom::symmetric(1));
  without.run(2.0);
  with.run(2.0);
  EXPECT_EQ(without.awareness.confidences().separability, with.awareness.confidences().separability);
  EXPECT_NE(without.awareness.confidences().evidence, 0.0);
  EXPECT_EQ(with.awareness.confidences().evidence, 0.0);
}

TEST(Separability, DetectsTwoAndFourEqualSides) {
  for (const int columns : {16, 32, 48, 64, 128}) {
    EXPECT_GT(KnownWall(columns, one_wave).probability(), 0.95) << columns;
    EXPECT_LT(KnownWall(columns, two_waves).probability(), 0.05) << columns;
    if (columns >= 32) {
      EXPECT_LT(KnownWall(columns, four_waves).probability(), 0.1) << columns;
    }
  }
}

TEST(Separability, HasThePriorValueIfNothingDiffersOrTooLittleIsKnown) {
  EXPECT_NEAR(KnownWall(48, gray).probability(), kUnknown, 0.01);
  EXPECT_NEAR(KnownWall(4, two_waves).probability(), kUnknown, 0.01) << "a wall that cannot be rotated by eighths";
  KnownWall few(48, two_waves);
  for (int column = 0; column < 9; ++column) few.separability.observe(few.compared, few.wall);
  EXPECT_NEAR(few.separability.probability(), kUnknown, 0.01) << "18 tiles";
  for (int column = 9; column < 24; ++column) few.separability.observe(few.compared, few.wall);
  EXPECT_LT(few.separability.probability(), 0.1);
}

TEST(Separability, HasThePriorValueIfViewsOfOneTileDifferAsMuchAsTiles) {
  KnownWall wall(48, one_wave);
  EXPECT_GT(wall.probability(), 0.95);
  for (int i = 0; i < 600; ++i) wall.separability.note_misfit(0.9, 0.1);
  EXPECT_NEAR(wall.probability(), kUnknown, 0.01);
}

TEST(Separability, UsesTheMisfitOfTheLastTwentySeconds) {
  KnownWall wall(48, one_wave), other(48, one_wave);
  wall.separability.note_misfit(0.9, 1.0);
  for (int i = 0; i < 2000; ++i) {
    wall.separability.note_misfit(0.1, 0.1);
    other.separability.note_misfit(0.1, 0.1);
  }
  EXPECT_NEAR(wall.probability(), other.probability(), 1e-3);
}

TEST(Separability, HasNoWeightBelowOneHalf) {
  KnownWall symmetric(48, two_waves);
  EXPECT_NEAR(symmetric.separability.weight(), 2.0 * kUnknown - 1.0, 0.01) << "without observations";
  static_cast<void>(symmetric.probability());
  EXPECT_EQ(symmetric.separability.weight(), 0.0);
}

RC_GTEST_PROP(Separability, ContinuesFromItsBytes, ()) {
  KnownWall wall(48, one_wave);
  const int columns = *rc::gen::inRange(0, 100);
  for (int i = 0; i < columns; ++i) {
    wall.separability.observe(wall.compared, wall.wall);
    wall.separability.note_misfit(0.01 * i, 0.1);
  }
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(wall.separability);
  Separability restored;
  restored.restart(48);
  ByteReader reader(bytes);
  reader(restored);
  wall.separability.observe(wall.compared, wall.wall);
  restored.observe(wall.compared, wall.wall);
  RC_ASSERT(restored.probability() == wall.separability.probability());
}

TEST(Separability, RefusesBytesOfAnotherWall) {
  KnownWall wall(48, one_wave);
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(wall.separability);
  Separability other;
  other.restart(32);
  ByteReader reader(bytes);
  EXPECT_THROW(reader(other), BadBytes);
}

}  // namespace
}  // namespace reorient
