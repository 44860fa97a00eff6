// SPDX-License-Identifier: MIT
// Two models: of one room on two days, of two parts of it, of two rooms, and with one of them rotated by 180 degrees.
#include "perception/room/model_comparison.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/painted_room.h"
#include "tests/perception/room/saved_models.h"

namespace reorient {
namespace {

using test::bytes_of;
using test::some_model;

TEST(ModelComparison, OfAModelWithItselfShowsNoDifference) {
  const SavedModel model = some_model(1);
  const ModelComparison comparison = compare(model, model);
  ASSERT_TRUE(comparison.mean);
  EXPECT_NEAR(*comparison.mean, 0.0, 1e-3);
  EXPECT_EQ(comparison.tiles.size(), 192u);
  EXPECT_TRUE(comparison.is_same_way());
  EXPECT_FALSE(comparison.is_turned());
}

TEST(ModelComparison, ListsTheTileThatWasPaintedOver) {
  const SavedModel before = some_model(1);
  std::vector<TileModel> tiles(before.model.tiles().begin(), before.model.tiles().end());
  tiles[77].mean = {};
  tiles[77].mean[13] = 1.0f;
  SavedModel after = before;
  after.model = BackgroundModel(tiles);
  const ModelComparison comparison = compare(before, after);
  EXPECT_EQ(comparison.tiles.front().tile, 77);
  EXPECT_GT(comparison.tiles.front().distance, 0.5);
  EXPECT_NEAR(comparison.tiles[1].distance, 0.0, 1e-3);
}

RC_GTEST_PROP(ModelComparison, RecognizesTheSameRoomOnAnotherDayRotatedOrNot, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const SavedModel first = some_model(seed, 0);
  SavedModel second = some_model(seed, 1);
  RC_ASSERT(compare(first, second).is_same_way() && !compare(first, second).is_turned());
  second.rotate_by_180_degrees();
  RC_ASSERT(compare(first, second).is_turned() && !compare(first, second).is_same_way());
}

RC_GTEST_PROP(ModelComparison, RecognizesOneRoomInEitherDirectionAndTwoRooms, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const int known = *rc::gen::inRange(30, 49);  // more than half, so that both directions can be compared
  const SavedModel first = some_model(seed, 0);
  SavedModel second = some_model(seed, 1, 0.2, 0, known), other = some_model(seed + 1, 1, 0.2, 0, known);
  RC_ASSERT(compare(first, second).is_of_one_room() && compare(second, first).is_of_one_room());
  RC_ASSERT(!compare(first, other).is_of_one_room() && !compare(other, first).is_of_one_room());
  second.rotate_by_180_degrees();
  other.rotate_by_180_degrees();
  RC_ASSERT(compare(first, second).is_of_one_room());
  RC_ASSERT(!compare(first, other).is_of_one_room());
}

TEST(ModelComparison, IsUndecidedWithoutEvidence) {
  const SavedModel symmetric = [] {
    SavedModel model = some_model(1);
    std::vector<TileModel> tiles(model.model.tiles().begin(), model.model.tiles().end());
    const Wall wall(model.basis.wall);
    for (int i = 0; i < wall.tiles(); ++i)
      tiles[static_cast<std::size_t>(std::max(i, wall.reflected(i)))] = tiles[static_cast<std::size_t>(i)];
    for (int i = 0; i < wall.tiles(); ++i)
      tiles[static_cast<std::size_t>(i)] = tiles[static_cast<std::size_t>(std::min(i, wall.reflected(i)))];
    model.model = BackgroundModel(tiles);
    return model;
  }();
  EXPECT_FALSE(compare(symmetric, symmetric).is_turned() || compare(symmetric, symmetric).is_same_way());
  EXPECT_TRUE(compare(symmetric, symmetric).is_of_one_room());

  const SavedModel left = some_model(1, 0, 0.1, 0, 20), right = some_model(1, 0, 0.1, 24, 20);
  const ModelComparison apart = compare(left, right);
  EXPECT_FALSE(apart.mean || apart.sides || apart.is_turned() || apart.is_same_way() || apart.is_of_one_room());
  EXPECT_EQ(apart.only_first, 80);
  EXPECT_EQ(apart.only_second, 80);

  const ModelComparison rooms = compare(some_model(1), some_model(2));
  EXPECT_FALSE(rooms.is_turned() || rooms.is_same_way()) << rooms.sides->as_it_is << " " << rooms.sides->turned;
}

RC_GTEST_PROP(MergedModel, IsIndependentOfTheOrder, ()) {
  const SavedModel a = some_model(*rc::gen::arbitrary<std::uint64_t>(), 0, 0.1, *rc::gen::inRange(0, 48), 30);
  const SavedModel b = some_model(*rc::gen::arbitrary<std::uint64_t>(), 1, 0.1, *rc::gen::inRange(0, 48), 30);
  const SavedModel both = merged(a, b);
  RC_ASSERT(bytes_of(both) == bytes_of(merged(b, a)));
  RC_ASSERT(bytes_of(read_model(bytes_of(both))) == bytes_of(both));
  for (int tile = 0; tile < 192; ++tile) {
    RC_ASSERT(both.model[tile].visits == a.model[tile].visits + b.model[tile].visits);
    if (b.model[tile].visits == 0) RC_ASSERT(both.model[tile].mean == a.model[tile].mean);
  }
}

TEST(MergedModel, HasTheMeanAndVarianceOfAllViews) {
  const auto one_tile = [](float share, int visits, double luma) {
    SavedModel model;
    model.basis.wall = {8.0, 0.7, 3.1, 1, 4};
    std::vector<TileModel> tiles(4);
    tiles[0].mean[0] = share;
    tiles[0].mean[1] = 1.0f - share;
    tiles[0].variance[0] = 0.02f;
    tiles[0].visits = tiles[0].light_visits = visits;
    tiles[0].trained = visits;
    tiles[0].light.luma = luma;
    model.learned = visits;
    model.model = BackgroundModel(tiles);
    return model;
  };
  const SavedModel both = merged(one_tile(0.2f, 10, 0.8), one_tile(0.6f, 30, 1.2));
  EXPECT_NEAR(both.model[0].mean[0], 0.5, 1e-6);
  EXPECT_NEAR(both.model[0].variance[0], 0.02 + 0.25 * 0.75 * 0.16, 1e-6);
  EXPECT_NEAR(both.model[0].light.luma, 1.1, 1e-12);
  EXPECT_EQ(both.model[0].visits, 40);
  EXPECT_EQ(both.model[0].trained, 40.0);
  EXPECT_EQ(both.learned, 40.0);
  EXPECT_EQ(both.model[1].visits, 0);
}

TEST(MergedModel, OfHugeNumbersOfViewsIsValid) {
  SavedModel model = some_model(1);
  std::vector<TileModel> tiles(model.model.tiles().begin(), model.model.tiles().end());
  for (TileModel& tile : tiles) {
    tile.visits = tile.light_visits = std::numeric_limits<int>::max();
    tile.trained = kLongestTraining;
  }
  model.model = BackgroundModel(tiles);
  model.learned = kLongestTraining;
  const SavedModel both = merged(model, model);
  EXPECT_EQ(both.model[0].visits, std::numeric_limits<int>::max());
  EXPECT_EQ(bytes_of(read_model(bytes_of(both))), bytes_of(both));
}

TEST(MergedModel, OfTwoRobotsGivesMoreEvidenceThanEither) {
  const test::PaintedRoom room = test::PaintedRoom::colorful(3);
  const auto learned_from = [&](const Pose2& place, std::uint64_t seed) {
    test::ScanningRobot robot(room, {}, seed);
    robot.truth = robot.belief = place;
    robot.run(20.0);
    SavedModel model{robot.awareness.basis(), 20.0, BackgroundModel()};
    model.model = robot.awareness.model();
    return model;
  };
  const SavedModel one = learned_from(Pose2(-3.2, -3.5, kPi / 2), 1);
  const SavedModel other = learned_from(Pose2(-3.2, 3.5, -kPi / 2), 2);
  const ModelComparison comparison = compare(one, other);
  EXPECT_GT(comparison.only_first, 0);
  EXPECT_GT(comparison.only_second, 0);
  const SavedModel both = merged(one, other);
  EXPECT_GT(both.model.known_tiles(), one.model.known_tiles());
  EXPECT_GT(both.model.known_tiles(), other.model.known_tiles());
}

}  // namespace
}  // namespace reorient
