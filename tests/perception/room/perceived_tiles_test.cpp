// SPDX-License-Identifier: MIT
#include "perception/room/wall/perceived_tiles.h"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/painted_room.h"

namespace reorient {
namespace {

struct Scene {
  explicit Scene(int width = 640, int height = 480, const Pose2& belief = {-2.0, 1.0, 0.4}) : image(width, height) {
    view.image = image.view();
    view.camera = CameraModel::from_fields_of_view(width, height, from_degrees(56.3), from_degrees(43.7));
    view.robot_from_camera = test::standing_camera(0.2, -0.1);
    view.belief = belief;
  }
  PerceivedTiles perceive(const Wall& wall = Wall{}, const PerceptionParameters& parameters = {}) {
    PerceivedTiles tiles;
    tiles.find(view, wall, parameters);
    tiles.count(view.image, {}, {}, parameters);
    return tiles;
  }
  Image image;
  RoomObservation view;
};

std::map<int, int> pixels_by_tile(const PerceivedTiles& tiles) {
  std::map<int, int> pixels;
  for (const TileBlock& block : tiles.blocks()) {
    for (int y = block.pixels.top; y < block.pixels.bottom; ++y) {
      for (int x = block.pixels.left; x < block.pixels.right; ++x) pixels[y * 10000 + x] = block.tile;
    }
  }
  return pixels;
}

Lens lens_of(CameraProjection projection, std::initializer_list<double> coefficients) {
  Lens lens;
  lens.projection = projection;
  EXPECT_EQ(lens.set_coefficients(std::vector<double>(coefficients)), "");
  return lens;
}

struct LensOfView {
  Lens lens;
  double width, height;  // degrees
};

TEST(PerceivedTiles, PixelsBelongToTheTileThatTheirRayMeets) {
  const Wall wall;
  const LensOfView lenses[] = {{lens_of(CameraProjection::pinhole, {}), 56.3, 43.7},
                               {lens_of(CameraProjection::pinhole, {-0.1, 0.0}), 56.3, 43.7},
                               {lens_of(CameraProjection::pinhole, {-0.2, 0.05, 0.002, -0.001, 0.01}), 80.0, 64.0},
                               {lens_of(CameraProjection::fisheye, {0.02, -0.004, 0.001, -0.0002}), 160.0, 120.0},
                               {lens_of(CameraProjection::fisheye, {}), 200.0, 150.0},
                               {lens_of(CameraProjection::equirectangular, {}), 200.0, 100.0}};
  for (const LensOfView& one : lenses) {
    for (const int width : {640, 160}) {
      Scene scene(width, width * 3 / 4);
      scene.view.camera = CameraModel::from_fields_of_view(width, width * 3 / 4, from_degrees(one.width),
                                                           from_degrees(one.height), one.lens);
      const auto pixels = pixels_by_tile(scene.perceive());
      const Isometry3 field_from_camera = to_isometry(scene.view.belief) * scene.view.robot_from_camera;
      const int height = scene.image.height(), all = width * height;
      std::vector<int> expected, found;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const Eigen::Vector3d ray = scene.view.camera.ray({static_cast<double>(x), static_cast<double>(y)});
          const auto point = wall.meet(field_from_camera.translation(), field_from_camera.linear() * ray);
          const bool on_wall = point && point->row >= 0 && point->row < wall.rows();
          expected.push_back(on_wall ? wall.tile(static_cast<int>(point->row), static_cast<int>(point->column)) : -1);
          const auto pixel = pixels.find(y * 10000 + x);
          found.push_back(pixel == pixels.end() ? -1 : pixel->second);
        }
      }
      // A pixel may be assigned to another tile only if that tile is close. A wider lens shows more borders.
      const int reach = std::max(2, height / 30);
      int differ = 0, far = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const int wrong = found[static_cast<std::size_t>(y * width + x)];
          if (wrong == expected[static_cast<std::size_t>(y * width + x)]) continue;
          ++differ;
          bool is_near = false;
          for (int v = std::max(0, y - reach); v <= std::min(height - 1, y + reach) && !is_near; ++v) {
            for (int u = std::max(0, x - reach); u <= std::min(width - 1, x + reach) && !is_near; ++u)
              is_near = expected[static_cast<std::size_t>(v * width + u)] == wrong;
          }
          far += is_near ? 0 : 1;
        }
      }
      SCOPED_TRACE(std::string(to_string(one.lens.projection)) + ", width " + std::to_string(width));
      EXPECT_LE(far, all / 2000) << "of " << differ;
      EXPECT_LT(differ, all / (one.width < 60.0 ? 25 : 16));
      EXPECT_GT(pixels.size(), static_cast<std::size_t>(all / 10));
    }
  }
}

TEST(PerceivedTiles, ATileFullyInViewHasTheExpectedArea) {
  Scene scene;
  const PerceivedTiles tiles = scene.perceive();
  int whole = 0;
  for (const PerceivedTile& tile : tiles.tiles()) {
    EXPECT_LT(tile.coverage(), 1.05);
    if (tile.coverage() > 0.97) ++whole;
  }
  EXPECT_GE(whole, 4);
}

TEST(PerceivedTiles, TheReflectedBeliefSeesTheReflectedTiles) {
  Scene scene;
  const PerceivedTiles tiles = scene.perceive();
  scene.view.belief = reflect(scene.view.belief);
  const PerceivedTiles reflected = scene.perceive();
  const Wall wall;
  std::map<int, double> areas;
  for (const PerceivedTile& tile : reflected.tiles()) areas[tile.tile] = tile.area;
  ASSERT_GT(tiles.tiles().size(), 4u);
  EXPECT_EQ(areas.size(), tiles.tiles().size());
  for (const PerceivedTile& tile : tiles.tiles()) EXPECT_EQ(areas[wall.reflected(tile.tile)], tile.area);
}

TEST(PerceivedTiles, CoveredAreasDoNotCount) {
  Scene scene;
  const std::vector<CoveredArea> covered = {
      {100, 50, 299, 400}, {280, 0, 330, 100}, {-50, -50, 3, 3}, {639, 0, 9999, 9999}};
  scene.view.covered = covered;
  const PerceivedTiles tiles = scene.perceive();
  for (const TileBlock& block : tiles.blocks()) {
    for (const CoveredArea& area : covered) {
      const bool apart = block.pixels.right <= area.left || block.pixels.left > area.right ||
                         block.pixels.bottom <= area.top || block.pixels.top > area.bottom;
      EXPECT_TRUE(apart);
    }
  }
  EXPECT_FALSE(tiles.blocks().empty());
}

TEST(PerceivedTiles, ATileThatIsMostlyCoveredDoesNotCount) {
  Scene scene;
  const auto before = scene.perceive();
  const std::vector<CoveredArea> covered = {{0, 0, 639, 479}};
  scene.view.covered = covered;
  EXPECT_TRUE(scene.perceive().tiles().empty());
  const std::vector<CoveredArea> half = {{0, 0, 319, 479}};
  scene.view.covered = half;
  const auto after = scene.perceive();
  const auto counting = [](const PerceivedTiles& tiles) {
    int count = 0;
    for (const PerceivedTile& tile : tiles.tiles()) count += tile.counts ? 1 : 0;
    return count;
  };
  EXPECT_LT(counting(after), counting(before));
  EXPECT_GT(counting(after), 0);
}

TEST(PerceivedTiles, NearAndSlantingTilesDoNotCount) {
  Scene scene(640, 480, {7.0, 0.0, 0.0});
  scene.view.robot_from_camera = test::standing_camera(0.0);
  const PerceivedTiles near = scene.perceive();
  for (const PerceivedTile& tile : near.tiles()) EXPECT_FALSE(tile.counts && tile.distance <= 1.5);
  scene.view.belief = {0.0, 7.0, 0.0};
  const PerceivedTiles beside = scene.perceive();
  int slanting = 0;
  for (const PerceivedTile& tile : beside.tiles()) {
    EXPECT_FALSE(tile.counts && tile.incidence <= 0.45);
    slanting += tile.incidence <= 0.45 ? 1 : 0;
  }
  EXPECT_GT(slanting, 0);
}

TEST(PerceivedTiles, SamplesAreEvenlySpacedRows) {
  Scene scene;
  PerceptionParameters parameters;
  parameters.sampled_rows = 480;
  const PerceivedTiles all = scene.perceive(Wall{}, parameters);
  parameters.sampled_rows = 160;
  const PerceivedTiles third = scene.perceive(Wall{}, parameters);
  ASSERT_EQ(all.tiles().size(), third.tiles().size());
  for (std::size_t i = 0; i < all.tiles().size(); ++i) {
    EXPECT_EQ(all.tiles()[i].samples, static_cast<int>(all.tiles()[i].area));
    EXPECT_NEAR(third.tiles()[i].samples, all.tiles()[i].samples / 3.0, 0.05 * all.tiles()[i].samples + 130);
  }
}

TEST(PerceivedTiles, ASmallerImageThanTheCamerasHasTheSameFieldOfView) {
  Scene scene;
  const PerceivedTiles full = scene.perceive();
  Image small(320, 240);
  scene.view.image = small.view();
  const PerceivedTiles half = scene.perceive();
  std::map<int, double> coverages;
  for (const PerceivedTile& tile : full.tiles()) coverages[tile.tile] = tile.coverage();
  ASSERT_GT(half.tiles().size(), 8u);
  for (const PerceivedTile& tile : half.tiles()) EXPECT_NEAR(tile.coverage(), coverages[tile.tile], 0.1);
}

TEST(PerceivedTiles, InvalidInputShowsNoTiles) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto expect_none = [](const char* what, auto&& spoil) {
    Scene scene;
    spoil(scene);
    EXPECT_TRUE(scene.perceive().tiles().empty()) << what;
  };
  expect_none("empty image", [](Scene& s) { s.view.image = {}; });
  expect_none("zero width", [](Scene& s) { s.view.image.width = 0; });
  expect_none("NaN position", [&](Scene& s) { s.view.belief.position.x() = nan; });
  expect_none("infinite position", [&](Scene& s) { s.view.belief.position.y() = infinity; });
  expect_none("NaN rotation", [&](Scene& s) { s.view.belief.rotation = nan; });
  expect_none("NaN camera pose", [&](Scene& s) { s.view.robot_from_camera.linear()(0, 0) = nan; });
  expect_none("outside of the wall", [](Scene& s) { s.view.belief.position = {20, 0}; });
  expect_none("far outside", [](Scene& s) { s.view.belief.position = {1e300, -1e300}; });
  expect_none("no camera", [](Scene& s) { s.view.camera.width = 0; });
  expect_none("NaN focal length", [&](Scene& s) { s.view.camera.focal.x() = nan; });
  expect_none("zero focal length", [](Scene& s) { s.view.camera.focal.setZero(); });
  expect_none("NaN distortion", [&](Scene& s) { s.view.camera.k1 = nan; });
  const auto looking = [](double pitch) {
    return [pitch](Scene& s) {
      s.view.robot_from_camera.linear() = Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()).toRotationMatrix();
    };
  };
  expect_none("straight down", looking(kPi / 2));
  expect_none("straight up", looking(-kPi / 2));
}

RC_GTEST_PROP(PerceivedTiles, AnyPoseGivesBlocksWithinTheImageThatDoNotOverlap, ()) {
  const auto number = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 100001) / 100000.0;
  };
  const int width = 2 * *rc::gen::inRange(1, 120);
  const int height = *rc::gen::inRange(1, 160);
  Scene scene(width, height, {number(-8, 8), number(-8, 8), number(-4, 4)});
  scene.view.camera = CameraModel::from_fields_of_view(width, height, number(0.1, 2.5), number(0.1, 2.5));
  scene.view.camera.k1 = number(-0.4, 0.4);
  scene.view.robot_from_camera.linear() = (Eigen::AngleAxisd(number(-4, 4), Eigen::Vector3d::UnitZ()) *
                                           Eigen::AngleAxisd(number(-4, 4), Eigen::Vector3d::UnitY()) *
                                           Eigen::AngleAxisd(number(-4, 4), Eigen::Vector3d::UnitX()))
                                              .toRotationMatrix();
  WallParameters wall;
  wall.rows = *rc::gen::inRange(1, 9);
  wall.columns = *rc::gen::inRange(2, 129);
  PerceptionParameters parameters;
  parameters.bands = *rc::gen::inRange(1, 100);
  const PerceivedTiles tiles = scene.perceive(Wall(wall), parameters);
  std::vector<char> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (const TileBlock& block : tiles.blocks()) {
    RC_ASSERT(block.tile >= 0 && block.tile < Wall(wall).tiles());
    RC_ASSERT(block.pixels.left >= 0 && block.pixels.right <= width && block.pixels.left < block.pixels.right);
    RC_ASSERT(block.pixels.top >= 0 && block.pixels.bottom <= height);
    for (int y = block.pixels.top; y < block.pixels.bottom; ++y) {
      for (int x = block.pixels.left; x < block.pixels.right; ++x) {
        char& pixel = seen[static_cast<std::size_t>(y * width + x)];
        RC_ASSERT(pixel == 0);
        pixel = 1;
      }
    }
  }
}

}  // namespace
}  // namespace reorient
