// SPDX-License-Identifier: MIT
#include "perception/room/wall/wall_sketch.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/camera.h"
#include "geometry/pose2.h"
#include "geometry/random.h"

namespace reorient {
namespace {

/// The narrowest version with optional instructions that the processor supports.
Instructions narrowest_wide_instructions() {
  return offered(Instructions::sse4) ? Instructions::sse4 : widest_instructions();
}

/// A random wall, and a camera inside it with a random direction, mostly forward.
struct SketchedView {
  explicit SketchedView(std::uint64_t seed)
      : random(seed), sketch(random.uniform() < 0.5 ? widest_instructions() : narrowest_wide_instructions()) {
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
    CameraModel camera = CameraModel::from_fields_of_view(640, 480, random.uniform(0.5, 1.6), 0.8);
    if (random.uniform() < 0.4) {
      Lens fisheye;
      fisheye.projection = CameraProjection::fisheye;
      const double span = random.uniform(1.0, 2.7);
      camera = CameraModel::from_fields_of_view(640, 480, span, 0.75 * span, fisheye);
    }
    for (int i = 0; i <= kBandCells; ++i)
      rays.push_back(camera.ray({i * 640.0 / kBandCells - 0.5, 239.5 - height * camera.focal.y()}));
    sketch.prepare(wall, field_from_camera);
    drawn = sketch.draw(BandRays::of(rays).value());
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
  std::vector<Eigen::Vector3d> rays;
  WallSketch sketch;
  bool drawn = false;
};

RC_GTEST_PROP(WallSketch, CertainResultsAreCorrect, (std::uint64_t seed)) {
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

/// The bounds need a margin.
RC_GTEST_PROP(WallSketch, ErrorsStayWithinHalfOfTheBounds, (std::uint64_t seed)) {
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

RC_GTEST_PROP(WallSketch, ACertainBorderRoundsToTheExactPixels, (std::uint64_t seed)) {
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

TEST(WallSketch, IsCertainOfNearlyAllThatARobotSees) {
  int sure = 0;
  int certain = 0;
  int all = 0;
  int changes = 0;
  for (int turn = 0; turn < 100; ++turn) {
    const Wall wall;
    Isometry3 field_from_camera = Isometry3::Identity();
    field_from_camera.linear() = rotation_about_z(0.063 * turn);
    field_from_camera.translation() = Eigen::Vector3d(-3.0 + 0.06 * turn, 1.0, 0.5);
    WallSketch sketch;
    sketch.prepare(wall, field_from_camera);
    std::vector<Eigen::Vector3d> rays;
    for (int i = 0; i <= kBandCells; ++i) rays.emplace_back(1.0, 0.5 - 0.025 * i, 0.1);
    ASSERT_TRUE(sketch.draw(BandRays::of(rays).value()));
    for (int ray = 0; ray < kBandCells; ++ray) {
      ++all;
      if (sketch.place(ray) != WallSketch::kUnsure) ++sure;
      if (sketch.place(ray) == sketch.place(ray + 1)) continue;
      ++changes;
      if (sketch.border(ray, 16.0)) ++certain;
    }
  }
  if (widest_instructions() != Instructions::portable) {
    EXPECT_GT(sure, 0.99 * all);
    EXPECT_GT(certain, 0.8 * changes);
  }
  EXPECT_GT(changes, all / 10);
}

TEST(WallSketch, IsNotUsedForTooFewRaysOrRaysFarOffTheAxis) {
  std::vector<Eigen::Vector3d> rays(kBandCells, Eigen::Vector3d::UnitX());
  EXPECT_FALSE(BandRays::of(rays));
  for (const double far : {1e3, -1e3, std::nan("")}) {
    rays.assign(kBandCells + 1, Eigen::Vector3d::UnitX());
    EXPECT_TRUE(BandRays::of(rays));
    rays[7].z() = far;
    EXPECT_FALSE(BandRays::of(rays));
  }
}

TEST(WallSketch, IsCertainOfNothingWithoutWideInstructions) {
  const std::vector<Eigen::Vector3d> rays(kBandCells + 1, Eigen::Vector3d::UnitX());
  Isometry3 field_from_camera = Isometry3::Identity();
  field_from_camera.translation().z() = 1.0;
  WallSketch sketch(Instructions::portable);
  sketch.prepare(Wall(), field_from_camera);
  EXPECT_TRUE(sketch.draw(BandRays::of(rays).value()));
  EXPECT_EQ(sketch.place(0), WallSketch::kUnsure);
}

TEST(WallSketch, IsCertainOfNothingNearTheWallOrIfTheCameraLooksUp) {
  const Wall wall;
  const std::vector<Eigen::Vector3d> rays(kBandCells + 1, Eigen::Vector3d::UnitX());
  for (const bool is_near : {true, false}) {
    Isometry3 field_from_camera = Isometry3::Identity();
    if (is_near) field_from_camera.translation().x() = 0.95 * wall.radius();
    if (!is_near) field_from_camera.linear() = rotation_about_y(-1.4);
    WallSketch sketch;
    sketch.prepare(wall, field_from_camera);
    EXPECT_TRUE(sketch.draw(BandRays::of(rays).value()));
    for (int ray = 0; ray < kBandCells; ++ray) {
      EXPECT_EQ(sketch.place(ray), WallSketch::kUnsure);
      EXPECT_FALSE(sketch.border(ray, 16.0));
    }
  }
}

}  // namespace
}  // namespace reorient
