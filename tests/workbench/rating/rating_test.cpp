// SPDX-License-Identifier: MIT
// Ratings of models of rooms, which are drawn at random.
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "perception/room/color/histogram_distance.h"
#include "tests/paths.h"
#include "tests/perception/room/saved_models.h"
#include "workbench/files/script_files.h"
#include "workbench/rating/room_rating.h"

namespace reorient {
namespace {

using test::some_model;

constexpr double kTrusted = 0.3;  // s

RatedRobot a_robot() {
  RatedRobot robot;
  robot.scripts = read_scripts(std::string(kSourceFolder) + "/scripts");
  robot.behaviors = {"orientation", "background_training", "kidnap_recovery", "goal_search", "wall_gaze", "head_scan"};
  return robot;
}

RatingOptions few_robots() {
  RatingOptions options;
  options.trials = 12;
  return options;
}

/// Each tile as its reflection.
SavedModel two_fold(SavedModel model) {
  const Wall wall(model.basis.wall);
  std::vector<TileModel> tiles(model.model.tiles().begin(), model.model.tiles().end());
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    if (const int other = wall.reflected(tile); tile < other)
      tiles[static_cast<std::size_t>(other)] = tiles[static_cast<std::size_t>(tile)];
  }
  model.model = BackgroundModel(std::move(tiles));
  return model;
}

/// White except for a few colored columns, so that most views contain no evidence.
SavedModel nearly_white() {
  SavedModel model = some_model(3);
  const Wall wall(model.basis.wall);
  std::vector<TileModel> tiles(model.model.tiles().begin(), model.model.tiles().end());
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    if (wall.column_of(tile) < 6) continue;
    ColorHistogram& mean = tiles[static_cast<std::size_t>(tile)].mean;
    mean = {};
    mean[1] = 1.0f;
  }
  model.model = BackgroundModel(std::move(tiles));
  return model;
}

double mean_misfit(const SavedModel& model, double scale) {
  const Wall wall(model.basis.wall);
  double sum = 0.0;
  const Looks looks = draw_looks(model.model, wall, kTrusted, scale, Random(7));
  for (int tile = 0; tile < wall.tiles(); ++tile)
    sum += distance(Distance::hellinger, looks[static_cast<std::size_t>(tile)], model.model[tile].mean);
  return sum / wall.tiles();
}

TEST(RoomRating, ReportsHowSoonAMirroredRobotIsCorrectedInAColorfulRoom) {
  const RoomRating rating = rate_room(some_model(1), a_robot(), few_robots());
  EXPECT_EQ(rating.verdict, RoomVerdict::works);
  ASSERT_TRUE(rating.times && rating.times->mean && rating.times->within_90);
  EXPECT_EQ(rating.times->corrected, 12);
  EXPECT_GT(*rating.times->mean, 1.0);
  EXPECT_LT(*rating.times->mean, 3.0);
  EXPECT_GE(*rating.times->within_90, *rating.times->mean - 0.5);
  ASSERT_TRUE(rating.false_flips && rating.false_flips->per_hour);
  EXPECT_EQ(rating.false_flips->flips, 0);
  EXPECT_LT(*rating.false_flips->per_hour, 0.1);
  ASSERT_EQ(rating.directions.size(), 48u);
  for (const DirectionRating& one : rating.directions) EXPECT_GT(one.log_odds, 0.0) << one.azimuth;
}

TEST(RoomRating, CallsItsSymmetricVersionSymmetric) {
  const RoomRating rating = rate_room(two_fold(some_model(1)), a_robot(), few_robots());
  EXPECT_EQ(rating.verdict, RoomVerdict::symmetric);
  EXPECT_FALSE(rating.times);
  EXPECT_FALSE(rating.false_flips);
  for (const DirectionRating& one : rating.directions) EXPECT_LT(std::abs(one.log_odds), 0.1) << one.azimuth;
}

TEST(RoomRating, ReportsThatAQuarterOfAWallIsTooLittle) {
  const RoomRating rating = rate_room(some_model(1, 0, 0.1, 0, 12), a_robot(), few_robots());
  EXPECT_EQ(rating.verdict, RoomVerdict::unlearned);
  EXPECT_NEAR(rating.coverage, 0.25, 1e-9);
  EXPECT_FALSE(rating.times);
  EXPECT_FALSE(rating.banner);
}

TEST(RoomRating, CallsAModelTooSmallThatBehaviorsWouldLearnFurther) {
  SavedModel model = some_model(1);
  model.learned = 2.0;
  const RoomRating rating = rate_room(model, a_robot(), few_robots());
  EXPECT_EQ(rating.verdict, RoomVerdict::unlearned);
  ASSERT_TRUE(rating.times);
  EXPECT_EQ(rating.times->evaluated, 0);
}

TEST(RoomRating, IsTheSameForOneSeed) {
  RatingOptions options = few_robots();
  options.banner_width = 0.0;
  const RoomRating first = rate_room(nearly_white(), a_robot(), options);
  const RoomRating again = rate_room(nearly_white(), a_robot(), options);
  ASSERT_TRUE(first.times && again.times);
  EXPECT_EQ(first.times->mean_up_to_limit, again.times->mean_up_to_limit);
  EXPECT_EQ(first.directions[5].log_odds, again.directions[5].log_odds);
  EXPECT_FALSE(first.banner);
}

TEST(RoomRating, EndsWhenItIsStopped) {
  int asked = 0;
  const RoomRating rating = rate_room(some_model(1), a_robot(), few_robots(), [&] { return ++asked > 3; });
  ASSERT_TRUE(rating.times);
  EXPECT_EQ(rating.times->trials, 3);
}

TEST(RoomRating, FollowsTheParametersOfScripts) {
  RatedRobot robot = a_robot();
  robot.parameters.push_back({"background_training.undisturbed_time", "2.5", ParameterOrigin::command_line, ""});
  RatingOptions options = few_robots();
  options.banner_width = 0.0;
  const RoomRating usual = rate_room(some_model(1), a_robot(), options),
                   later = rate_room(some_model(1), robot, options);
  ASSERT_TRUE(usual.times->mean && later.times->mean);
  EXPECT_NEAR(*later.times->mean - *usual.times->mean, 2.0, 0.3);
}

TEST(RoomRating, TakesLongerIfObservationsFitWorse) {
  RatingOptions options = few_robots();
  options.banner_width = 0.0;
  const RoomRating good = rate_room(nearly_white(), a_robot(), options);
  options.misfit = 0.6;
  const RoomRating bad = rate_room(nearly_white(), a_robot(), options);
  EXPECT_LE(good.times->mean_up_to_limit, bad.times->mean_up_to_limit);
}

TEST(BannerRating, NamesThePlaceThatHelpsMostIfAnyHelps) {
  const RoomRating rating = rate_room(nearly_white(), a_robot(), few_robots());
  ASSERT_TRUE(rating.banner);
  EXPECT_EQ(rating.banner->places.size(), 24u);
  const double without = rating.banner->without.mean_up_to_limit;
  const double best = rating.banner->with ? rating.banner->with->mean_up_to_limit : 0.98 * without;
  EXPECT_LE(best, 0.98 * without);
  for (const BannerTry& one : rating.banner->places) {
    EXPECT_TRUE(one.is_usable) << one.azimuth;
    EXPECT_GE(one.times.mean_up_to_limit, best) << one.azimuth;
    EXPECT_LE(one.times.mean_up_to_limit, 1.05 * without) << one.azimuth;
  }
}

TEST(Banner, AddsEvidenceOnlyAtItsPosition) {
  const CoreParameters core = core_parameters_of(a_robot());
  const SavedModel room = nearly_white();
  Banner banner;
  banner.azimuth = from_degrees(93.75);  // the middle of column 12
  banner.color = rarest_color(room.model);
  const auto rated = [&](const SavedModel& model) {
    return rate_directions(RatedModel(model, core), core.room, 0.0, 1, 1);
  };
  const std::vector<DirectionRating> before = rated(room), after = rated(with_banner(room, banner));
  EXPECT_GT(after[12].log_odds, before[12].log_odds + 0.1);
  EXPECT_GT(after[36].log_odds, before[36].log_odds + 0.1) << "nor is it seen where it should hang";
  // Two meters are nearly two columns of 7.5 degrees; the mean difference of the room differs slightly.
  for (const int far : {8, 16, 20, 30}) {
    const auto i = static_cast<std::size_t>(far);
    EXPECT_NEAR(after[i].log_odds, before[i].log_odds, 1e-6) << far;
  }
}

TEST(Banner, KeepsHistogramsNormalizedAndUnknownTilesUnknown) {
  const SavedModel room = some_model(2, 0, 0.1, 0, 24);
  Banner banner;
  banner.azimuth = from_degrees(179.0);  // half of it on the known side
  banner.width = 6.0;
  const SavedModel changed = with_banner(room, banner);
  int covered = 0;
  for (int tile = 0; tile < Wall(room.basis.wall).tiles(); ++tile) {
    const TileModel& one = changed.model[tile];
    EXPECT_EQ(one.visits, room.model[tile].visits);
    if (one.visits == 0) {
      EXPECT_EQ(one.mean, ColorHistogram{});
      continue;
    }
    EXPECT_NEAR(std::accumulate(one.mean.begin(), one.mean.end(), 0.0), 1.0, 1e-5);
    covered += one.mean != room.model[tile].mean ? 1 : 0;
  }
  EXPECT_GT(covered, 3);
  EXPECT_LT(covered, 20);
}

TEST(Banner, HasAColorThatIsNotOnTheWall) {
  SavedModel model = some_model(1);
  std::vector<TileModel> tiles(model.model.tiles().begin(), model.model.tiles().end());
  for (TileModel& tile : tiles) tile.mean[9] = 0.0f;
  EXPECT_EQ(rarest_color(BackgroundModel(tiles)), 9);
  EXPECT_STREQ(color_in_words(2), "dark green");
  EXPECT_STREQ(color_in_words(13), "light violet");
}

TEST(SyntheticLooks, DifferFromTheModelByTheGivenMisfit) {
  const SavedModel model = some_model(1);
  const Wall wall(model.basis.wall);
  for (const double misfit : {0.05, 0.2, 0.35}) {
    const double scale = scale_for_misfit(model.model, wall, kTrusted, misfit);
    EXPECT_NEAR(mean_misfit(model, scale), misfit, 0.03);
  }
}

TEST(SyntheticLooks, UseTheColorsOfTheRowForUnknownTiles) {
  const SavedModel model = some_model(1, 0, 0.1, 0, 12);
  const Wall wall(model.basis.wall);
  const Looks looks = draw_looks(model.model, wall, kTrusted, 0.0, Random(1));
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    bool is_of_its_row = false;
    for (int column = 0; column < 12; ++column)
      is_of_its_row |= distance(Distance::hellinger, looks[static_cast<std::size_t>(tile)],
                                model.model[wall.tile(wall.row_of(tile), column)].mean) < 1e-3;
    EXPECT_TRUE(is_of_its_row) << tile;
  }
}

TEST(VisibleTiles, AreInTheDirectionOfTheHead) {
  const Wall wall;
  VisibleTiles visible(RobotBody(), wall, {}, Pose2(0.0, 0.0, 0.0));
  for (const double yaw : {-1.2, 0.0, 1.2}) {
    const std::vector<PerceivedTile>& tiles = visible.at({yaw, -0.1});
    ASSERT_FALSE(tiles.empty());
    for (const PerceivedTile& tile : tiles) {
      const double azimuth = (wall.column_of(tile.tile) + 0.5) * wall.column_width();
      EXPECT_LT(std::abs(angle_difference(azimuth, yaw)), 0.7);
    }
  }
}

TEST(Directions, AreNamedInStepsOf45Degrees) {
  EXPECT_EQ(direction_in_words(0.0), "toward the opponent goal");
  EXPECT_EQ(direction_in_words(from_degrees(91.0)), "toward the left touch line");
  EXPECT_EQ(direction_in_words(from_degrees(-91.0)), "toward the right touch line");
  EXPECT_EQ(direction_in_words(from_degrees(181.0)), "toward the own goal");
  EXPECT_EQ(direction_in_words(from_degrees(-135.0)), "toward the right corner of the own half");
}

TEST(Directions, ThatAreBestOrWorstAreSeparated) {
  std::vector<DirectionRating> all(48);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].azimuth = normalize_angle((static_cast<double>(i) + 0.5) * 2.0 * kPi / 48.0);
    all[i].log_odds = i < 12 ? 3.0 + 0.01 * static_cast<double>(i) : 1.0;
  }
  const std::vector<DirectionRating> best = best_directions(all, 3), worst = worst_directions(all, 3);
  ASSERT_EQ(best.size(), 3u);
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_NEAR(best[0].log_odds, 3.1, 1e-9) << "column 10, with its neighbors";
  EXPECT_NEAR(worst[0].log_odds, 1.0, 1e-9);
  for (std::size_t i = 1; i < 3; ++i)
    EXPECT_GE(std::abs(angle_difference(best[i].azimuth, best[0].azimuth)), from_degrees(44.9));
}

}  // namespace
}  // namespace reorient
