#include "perception/room/wall/wall_sketch.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/camera.h"
#include "geometry/pose2.h"
#include "geometry/random.h"

namespace reorient {
namespace {

/// Some wall, and a camera somewhere in it that looks somewhere, mostly ahead.
struct SketchedView {
  explicit SketchedView(std::uint64_t seed) : random(seed) {
    WallParameters parameters;
    if (random.uniform() < 0.7) {
      parameters.radius = random.uniform(3.0, 20.0);
      parameters.bottom = random.uniform(0.0, 1.5);
      parameters.top = parameters.bottom + random.uniform(0.3, 8.0);
      parameters.rows = 1 + static_cast<int>(random.below(8));
      parameters.columns = 4 + 2 * static_cast<int>(random.below(63));
    }
    wall = Wall(parameters);
    const double far = 0.95 * wall.radius() * std::sqrt(random.uniform());
    field_from_camera.linear() = rotation_about_z(random.uniform(-kPi, kPi)) *
                                 rotation_about_y(random.uniform(-1.0, 1.0)) *
                                 rotation_about_x(random.uniform(-0.5, 0.5));
    field_from_camera.translation().head<2>() = far * unit_vector(random.uniform(-kPi, kPi));
    field_from_camera.translation().z() = random.uniform(0.1, 2.0);
    const double height = random.uniform(-0.5, 0.5);
    const CameraModel camera = CameraModel::from_fields_of_view(640, 480, random.uniform(0.5, 1.6), 0.8);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double u = std::min(static_cast<double>(i), 1.0 * kBandCells) * 640 / kBandCells - 0.5;
      rays[i] = camera.ray({u, 239.5 - height * camera.focal.y()});
      y[i] = static_cast<float>(rays[i].y());
      z[i] = static_cast<float>(rays[i].z());
    }
    sketch.prepare(wall, field_from_camera);
    drawn = sketch.draw(y, z);
  }

  std::optional<WallPoint> exact(int ray) const {
    return wall.meet(field_from_camera.translation(), field_from_camera.linear() * rays[static_cast<std::size_t>(ray)]);
  }
  int exact_place(int ray) const {
    const auto point = exact(ray);
    if (!point || point->row < 0.0) return WallSketch::kBelow;
    if (point->row >= wall.rows()) return WallSketch::kAbove;
    return wall.tile(static_cast<int>(point->row), static_cast<int>(point->column));
  }

  Random random;
  Wall wall;
  Isometry3 field_from_camera = Isometry3::Identity();
  std::array<Eigen::Vector3d, std::tuple_size_v<BandRays>> rays;
  BandRays y{}, z{};
  WallSketch sketch;
  bool drawn = false;
};

RC_GTEST_PROP(WallSketch, WhatItIsSureOfIsTrue, (std::uint64_t seed)) {
  const SketchedView view(seed);
  for (int ray = 0; ray <= kBandCells; ++ray) {
    if (!view.drawn) {
      const auto point = view.exact(ray);
      RC_ASSERT(!point || point->row < 0.0);
    } else if (view.sketch.place(ray) != WallSketch::kUnsure) {
      RC_ASSERT(view.sketch.place(ray) == view.exact_place(ray));
    }
  }
}

/// So that there is something to spare.
RC_GTEST_PROP(WallSketch, ErrorsStayWithinHalfOfTheirBounds, (std::uint64_t seed)) {
  const SketchedView view(seed);
  for (int ray = 0; view.drawn && ray <= kBandCells; ++ray) {
    if (view.sketch.place(ray) < 0) continue;
    const auto point = view.exact(ray);
    RC_ASSERT(point.has_value());
    const double columns = std::remainder(view.sketch.column(ray) - point->column, view.wall.columns());
    RC_ASSERT(std::abs(columns) < 0.5 * view.sketch.column_error());
    RC_ASSERT(std::abs(view.sketch.row(ray) - point->row) < 0.5 * view.sketch.row_error());
  }
}

RC_GTEST_PROP(WallSketch, ABorderItTellsRoundsAsTheExactOneDoes, (std::uint64_t seed)) {
  const SketchedView view(seed);
  constexpr double kWidth = 16.0;
  for (int ray = 0; view.drawn && ray < kBandCells; ++ray) {
    const auto border = view.sketch.border(ray, kWidth);
    if (!border) continue;
    const auto left = view.exact(ray);
    const auto right = view.exact(ray + 1);
    RC_ASSERT(left && right);
    const double columns = std::remainder(right->column - left->column, view.wall.columns());
    const double rows = right->row - left->row;
    const double end_column = left->column + columns;
    const bool crosses_column = std::floor(left->column) != std::floor(end_column);
    const double place =
        crosses_column
            ? ((columns > 0.0 ? std::floor(left->column) + 1.0 : std::floor(left->column)) - left->column) / columns
            : (std::clamp(std::floor(std::max(left->row, right->row)), 0.0, 1.0 * view.wall.rows()) - left->row) / rows;
    RC_ASSERT(place >= 0.0);
    RC_ASSERT(place <= 1.0);
    RC_ASSERT(std::lround(0.5 * (ray + place) * kWidth) == std::lround(0.5 * (ray + *border) * kWidth));
  }
}

TEST(WallSketch, IsSureOfNearlyAllThatARobotSees) {
  int sure = 0;
  int told = 0;
  int all = 0;
  int changes = 0;
  for (int turn = 0; turn < 100; ++turn) {
    const Wall wall;
    Isometry3 field_from_camera = Isometry3::Identity();
    field_from_camera.linear() = rotation_about_z(0.063 * turn);
    field_from_camera.translation() = Eigen::Vector3d(-3.0 + 0.06 * turn, 1.0, 0.5);
    WallSketch sketch;
    sketch.prepare(wall, field_from_camera);
    BandRays y{}, z{};
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] = 0.5f - 0.025f * static_cast<float>(i);
      z[i] = 0.1f;
    }
    ASSERT_TRUE(sketch.draw(y, z));
    for (int ray = 0; ray < kBandCells; ++ray) {
      ++all;
      if (sketch.place(ray) != WallSketch::kUnsure) ++sure;
      if (sketch.place(ray) == sketch.place(ray + 1)) continue;
      ++changes;
      if (sketch.border(ray, 16.0)) ++told;
    }
  }
#ifdef __SSE4_1__
  EXPECT_GT(sure, 0.99 * all);
  EXPECT_GT(told, 0.8 * changes);
#endif
  EXPECT_GT(changes, all / 10);
}

TEST(WallSketch, IsSureOfNothingNearTheWallNorWhereTheCameraLooksUp) {
  const Wall wall;
  BandRays y{}, z{};
  for (const bool is_near : {true, false}) {
    Isometry3 field_from_camera = Isometry3::Identity();
    if (is_near) field_from_camera.translation().x() = 0.95 * wall.radius();
    if (!is_near) field_from_camera.linear() = rotation_about_y(-1.4);
    WallSketch sketch;
    sketch.prepare(wall, field_from_camera);
    EXPECT_TRUE(sketch.draw(y, z));
    for (int ray = 0; ray < kBandCells; ++ray) {
      EXPECT_EQ(sketch.place(ray), WallSketch::kUnsure);
      EXPECT_FALSE(sketch.border(ray, 16.0));
    }
  }
}

}  // namespace
}  // namespace reorient
