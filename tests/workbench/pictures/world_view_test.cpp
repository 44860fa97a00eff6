// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/world_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/angle.h"
#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/scene/color.h"

namespace reorient::pictures {
namespace {

// Pixels of a color in the right or left half of the part inside the legends.
int to_the_right(const Picture& picture, Color color) { return count(picture, color, 760, 0, 1180, 940); }
int to_the_left(const Picture& picture, Color color) { return count(picture, color, 320, 0, 740, 940); }

WallTile tile(double azimuth, int row, int bin) {
  WallTile result{azimuth - 0.1, azimuth + 0.1, row, {}};
  result.histogram.share[static_cast<std::size_t>(bin)] = 1.0F;
  return result;
}

TEST(WorldView, DrawsTruthAndBeliefWhereTheyAre) {
  WorldView world;
  world.truth = Pose2(3.0, 0.0, 0.0);
  world.belief = Pose2(-3.0, 0.0, kPi);
  const Picture picture = draw_world_view(world);
  EXPECT_GT(to_the_right(picture, palette::truth), 100);
  EXPECT_EQ(to_the_left(picture, palette::truth), 0);
  EXPECT_GT(to_the_left(picture, palette::belief), 60);
  EXPECT_EQ(to_the_right(picture, palette::belief), 0);
}

TEST(WorldView, KeepsTheTruthVisibleBelowACorrectBelief) {
  WorldView world;
  world.truth = world.belief = Pose2(2.0, 0.0, 0.5);
  EXPECT_GT(to_the_right(draw_world_view(world), palette::truth), 30);
}

TEST(WorldView, DrawsATileInItsDirectionAndPerceivedTilesFurtherOut) {
  const auto farthest = [](const Picture& picture, Color color) {
    double distance = 0.0;
    for (int y = 0; y < 900; ++y)
      for (int x = 0; x < picture.width; ++x)
        if (is_similar(picture.at(x, y), color)) distance = std::max(distance, std::hypot(x - 750.0, y - 600.0));
    return distance;
  };
  constexpr int kPurple = 5;
  WorldView world;
  world.model = {tile(kPi / 2.0, 0, kPurple)};
  const Picture low = draw_world_view(world);
  EXPECT_GT(count(low, scene::bin_color(kPurple), 700, 0, 800, 600), 50);  // y left is up
  EXPECT_EQ(count(low, scene::bin_color(kPurple), 0, 600, 1180, 1200), 0);

  world.model.push_back(tile(kPi / 2.0, 1, 0));
  WorldView above;
  above.model = {tile(kPi / 2.0, 1, kPurple)};
  WorldView seen;
  seen.perceived = {tile(kPi / 2.0, 0, kPurple)};
  EXPECT_GT(farthest(draw_world_view(above), scene::bin_color(kPurple)),
            farthest(draw_world_view(world), scene::bin_color(kPurple)));
  EXPECT_GT(farthest(draw_world_view(seen), scene::bin_color(kPurple)), farthest(low, scene::bin_color(kPurple)));
}

TEST(WorldView, ColorsPerceivedTilesByThePoseThatTheyMatch) {
  const auto drawn = [](std::optional<double> evidence) {
    WorldView world;
    world.perceived = {tile(0.0, 0, 0)};
    world.perceived[0].evidence = evidence;
    return draw_world_view(world);
  };
  const auto on_tile = [](const Picture& picture, Color color) { return count(picture, color, 1250, 500, 1330, 700); };
  EXPECT_GT(on_tile(drawn(-5.0), palette::belief), 300);
  EXPECT_EQ(on_tile(drawn(-5.0), palette::opposite), 0);
  EXPECT_GT(on_tile(drawn(5.0), palette::opposite), 300);
  EXPECT_GT(on_tile(drawn(0.0), palette::no_evidence), 300);
  EXPECT_GT(on_tile(drawn(kNaN), palette::no_evidence), 300);
  EXPECT_EQ(on_tile(drawn({}), palette::belief) + on_tile(drawn({}), palette::opposite), 0);
}

TEST(WorldView, ListsOnlyTheColorsOfTilesThatItShows) {
  const auto in_legend = [](double evidence, Color color) {
    WorldView world;
    world.perceived = {tile(0.0, 0, 0)};
    world.perceived[0].evidence = evidence;
    return count(draw_world_view(world), color, 1230, 60, 1280, 160);
  };
  EXPECT_GT(in_legend(-0.1, palette::belief), 100);
  EXPECT_EQ(in_legend(-0.1, palette::opposite), 0);
  EXPECT_GT(in_legend(0.1, palette::opposite), 100);
  EXPECT_EQ(in_legend(0.1, palette::belief), 0);
}

TEST(WorldView, DrawsEachViewParticleInMagenta) {
  WorldView world;
  world.view_particles = {0.0, 0.5, -0.5};
  const int three = to_the_right(draw_world_view(world), palette::view_particle);
  world.view_particles = {0.0};
  const int one = to_the_right(draw_world_view(world), palette::view_particle);
  EXPECT_GT(one, 5);
  EXPECT_GT(three, 2 * one);
}

TEST(WorldView, DrawsTheCellsOfAGridAsBarsWithTheSquareRootOfTheirFraction) {
  WorldView world;
  world.view_cells = {{-0.1, 0.1, 0.8}, {kPi - 0.1, kPi + 0.1, 0.2}};
  const Picture picture = draw_world_view(world);
  const int greater = to_the_right(picture, palette::view_particle);
  EXPECT_GT(greater, 500);
  EXPECT_NEAR(to_the_left(picture, palette::view_particle), 0.5 * greater, 0.1 * greater);
}

TEST(WorldView, MarksTheCurrentViewAndItsOpposite) {
  WorldView world;
  world.view_azimuth = 0.0;
  const Picture picture = draw_world_view(world);
  EXPECT_GT(to_the_right(picture, {212, 222, 241}), 500);  // a fifth of the belief's blue on the page
  EXPECT_GT(to_the_left(picture, {243, 210, 210}), 500);
  EXPECT_LT(to_the_left(picture, {212, 222, 241}), 20);  // a few soft edges
}

TEST(WorldView, KeepsTilesClearOfTitleAndLegends) {
  WorldView world;
  world.note = std::string(500, 'w');
  world.truth = world.belief = Pose2();
  world.pose_particles = {Pose2()};
  world.view_particles = {0.0};
  world.view_clusters = {{0.0, 0.1}};
  world.view_azimuth = 0.0;
  const Picture without = draw_world_view(world);
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 32; ++i) world.perceived.push_back(tile(i * kPi / 16.0, row, 0));
  const Picture with = draw_world_view(world);
  int overlaps = 0;  // pixels of title or legends that the tiles changed
  for (int y = 0; y < with.height; ++y)
    for (int x = 0; x < with.width; ++x)
      if (std::hypot(x - 750.0, y - 600.0) > 480.0 && without.at(x, y) != palette::page)
        overlaps += with.at(x, y) == without.at(x, y) ? 0 : 1;
  EXPECT_EQ(overlaps, 0);
}

TEST(WorldView, DrawsAnUnknownWorld) {
  const Picture picture = draw_world_view({});
  EXPECT_EQ(picture.width, 1500);
  EXPECT_GT(count(picture, palette::carpet), 10000);
  EXPECT_EQ(count(picture, palette::truth) + count(picture, palette::belief), 0);
}

TEST(WorldView, OmitsValuesThatAreNotFinite) {
  WorldView world;
  WorldView without;
  world.truth = without.truth = Pose2(2.0, 1.0, 0.0);
  world.view_particles = without.view_particles = {0.3};
  world.view_particles.push_back(kNaN);
  world.pose_particles = without.pose_particles = {Pose2(1.0, 1.0, 1.0)};
  world.pose_particles.emplace_back(kNaN, 0.0, 0.0);
  world.model = without.model = {tile(1.0, 0, 3)};
  for (const WallTile& bad : {tile(kNaN, 0, 3), tile(1e300, 0, 3), tile(2.0, -1, 3), tile(2.0, 1000000, 3)}) {
    world.model.push_back(bad);
    world.perceived.push_back(bad);
    world.untrained.push_back(bad);
  }
  world.view_cells = without.view_cells = {{0.5, 0.6, 0.2}};
  for (const ViewCell& bad :
       {ViewCell{kNaN, 0.6, 0.1}, {0.5, kNaN, 0.1}, {0.5, 0.6, kNaN}, {0.5, 0.6, -1.0}, {0.5, 0.6, 1e300}})
    world.view_cells.push_back(bad);
  world.view_clusters = without.view_clusters = {{1.0, 0.1}};
  world.view_clusters.push_back({kNaN, 0.1});
  world.view_clusters.push_back({0.1, kNaN});
  world.belief = Pose2(kNaN, kNaN, kNaN);
  // An invalid belief adds only its entry in the legend.
  const Picture picture = draw_world_view(world);
  const Picture expected = draw_world_view(without);
  int different = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 330; x < picture.width; ++x) different += picture.at(x, y) == expected.at(x, y) ? 0 : 1;
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace reorient::pictures
