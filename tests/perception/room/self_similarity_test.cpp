// Whether the room looks the same after half a turn.
#include "perception/room/self_similarity.h"

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

double asymmetry_of(const PaintedRoom& room, const RoomParameters& parameters = {}) {
  ScanningRobot robot(room, parameters, 1);
  for (int quarter = 0; quarter < 4; ++quarter) {  // a head alone does not see all of the walls
    robot.run(4.0);
    robot.truth.rotation += kPi / 2;
    robot.belief = robot.truth;
  }
  return robot.awareness.confidences().asymmetry;
}

/// A wall whose tiles are all known, each with its share of black and the rest of white.
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
    similarity.restart(columns);
  }

  double asymmetry() {
    for (int column = 0; column < wall.columns(); ++column) similarity.observe(compared, wall);
    return similarity.asymmetry();
  }

  Wall wall;
  ComparedModel compared;
  SelfSimilarity similarity;

 private:
  BackgroundModel model_;
};

double one_wave(double turns) { return 0.5 + 0.4 * std::sin(2.0 * kPi * turns); }
double two_waves(double turns) { return 0.5 + 0.4 * std::sin(4.0 * kPi * turns); }
double four_waves(double turns) { return 0.5 + 0.4 * std::sin(8.0 * kPi * turns); }
double grey(double) { return 0.5; }

TEST(SelfSimilarity, IsAboutTheSameForEveryTurnWhereNothingIsRepeated) {
  for (const std::uint64_t seed : {1, 2, 3}) EXPECT_GT(asymmetry_of(PaintedRoom::colorful(seed)), 0.8) << seed;
}

TEST(SelfSimilarity, IsGreaterAfterHalfATurnInASymmetricRoom) {
  for (const std::uint64_t seed : {1, 2, 3}) EXPECT_LT(asymmetry_of(PaintedRoom::symmetric(seed)), 0.79) << seed;
}

TEST(SelfSimilarity, KnowsTwoAndFourEqualSides) {
  for (const int columns : {16, 32, 48, 64, 128}) {
    EXPECT_GT(KnownWall(columns, one_wave).asymmetry(), 1.0) << columns;
    EXPECT_LT(KnownWall(columns, two_waves).asymmetry(), 1e-3) << columns;
    if (columns >= 32) {
      EXPECT_LT(KnownWall(columns, four_waves).asymmetry(), 0.1) << columns;
    }
  }
}

TEST(SelfSimilarity, SaysNothingWhereNothingDiffersOrTooLittleIsKnown) {
  EXPECT_EQ(KnownWall(48, grey).asymmetry(), 1.0);
  EXPECT_EQ(KnownWall(4, two_waves).asymmetry(), 1.0) << "a wall without eighths";
  KnownWall few(48, two_waves);
  for (int column = 0; column < 9; ++column) few.similarity.observe(few.compared, few.wall);
  EXPECT_EQ(few.similarity.asymmetry(), 1.0) << "18 tiles";
  few.similarity.observe(few.compared, few.wall);
  EXPECT_LT(few.similarity.asymmetry(), 0.1);
}

RC_GTEST_PROP(SelfSimilarity, GoesOnFromItsBytes, ()) {
  KnownWall wall(48, one_wave);
  const int columns = *rc::gen::inRange(0, 100);
  for (int i = 0; i < columns; ++i) wall.similarity.observe(wall.compared, wall.wall);
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(wall.similarity);
  SelfSimilarity restored;
  restored.restart(48);
  ByteReader reader(bytes);
  reader(restored);
  wall.similarity.observe(wall.compared, wall.wall);
  restored.observe(wall.compared, wall.wall);
  RC_ASSERT(restored.asymmetry() == wall.similarity.asymmetry());
}

TEST(SelfSimilarity, RefusesBytesOfAnotherWall) {
  KnownWall wall(48, one_wave);
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  writer(wall.similarity);
  SelfSimilarity other;
  other.restart(32);
  ByteReader reader(bytes);
  EXPECT_THROW(reader(other), BadBytes);
}

}  // namespace
}  // namespace reorient
