// SPDX-License-Identifier: MIT
#include "perception/room/wall/perceived_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace reorient {
namespace {

constexpr int kCells = kBandCells;  // per band: between their borders, positions on the wall are interpolated

int row_step(int height, const PerceptionParameters& parameters) {
  return std::max(1, height / std::max(parameters.sampled_rows, 1));
}

/// The position, between 0 and 1, at which the values from `a` to `b` first cross an integer after `t`. 1 if they do
/// not.
double next_crossing(double a, double b, double t) {
  const double slope = b - a;
  if (std::abs(slope) < 1e-12) return 1.0;
  const double now = a + t * slope;
  constexpr double kMargin = 1e-9;
  const double border = slope > 0.0 ? std::floor(now + kMargin) + 1.0 : std::ceil(now - kMargin) - 1.0;
  return std::min((border - a) / slope, 1.0);
}

}  // namespace

void PerceivedTiles::clear() {
  blocks_.clear();
  tiles_.clear();
  lights_.clear();
}

void PerceivedTiles::find(const RoomObservation& view, const Wall& wall, const PerceptionParameters& parameters) {
  clear();
  const auto tiles = static_cast<std::size_t>(wall.tiles());
  counts_.assign(tiles, TileCount{});
  tiles_.reserve(tiles);
  lights_.reserve(tiles);
  const auto camera = camera_of(view);
  if (!camera) return;
  const Isometry3 field_from_camera = to_isometry(view.belief) * view.robot_from_camera;
  if (!wall.surrounds(field_from_camera.translation().head<2>())) return;

  prepare_rays(*camera, std::clamp(parameters.bands, 1, camera->height));
  sketch_.prepare(wall, field_from_camera);
  for (int band = 0; band < bands_; ++band) find_in_band(band, field_from_camera, wall, view.covered);
  measure(field_from_camera, *camera, wall);
}

void PerceivedTiles::prepare_rays(const CameraModel& camera, int bands) {
  if (bands == bands_ && camera == camera_) return;
  camera_ = camera;
  bands_ = bands;
  rays_.clear();
  rays_.reserve(static_cast<std::size_t>(bands) * (kCells + 1));
  for (int band = 0; band < bands; ++band) {
    const int top = band * camera.height / bands;
    const int bottom = (band + 1) * camera.height / bands;
    for (int i = 0; i <= kCells; ++i) {
      const double x = static_cast<double>(i) * camera.width / kCells - 0.5;
      rays_.push_back(camera.ray({x, 0.5 * (top + bottom - 1)}));
    }
  }
  rough_rays_.clear();
  rough_rays_.reserve(static_cast<std::size_t>(bands));
  for (std::size_t first = 0; first < rays_.size(); first += kCells + 1)
    rough_rays_.push_back(BandRays::of(std::span(rays_).subspan(first, kCells + 1)));
  covered_.assign(static_cast<std::size_t>(camera.width / 2 + 1), 0);
  // Every cell may show a new tile, and covered areas may split each. This is enough except for extreme cases.
  blocks_.reserve(static_cast<std::size_t>(bands) * kCells);
}

void PerceivedTiles::find_in_band(int band, const Isometry3& field_from_camera, const Wall& wall,
                                  std::span<const CoveredArea> covered) {
  const int top = band * camera_.height / bands_;
  const int bottom = (band + 1) * camera_.height / bands_;
  const auto& rays = rough_rays_[static_cast<std::size_t>(band)];
  if (!rays) sketch_.leave_blank();
  if (rays && !sketch_.draw(*rays)) return;
  any_covered_ = false;
  for (const CoveredArea& area : covered) {
    if (area.bottom < top || area.top >= bottom) continue;
    if (!any_covered_) std::fill(covered_.begin(), covered_.end(), std::uint8_t{0});
    any_covered_ = true;
    const int first = std::clamp(area.left, 0, camera_.width) / 2;
    const int last = std::clamp(area.right, -1, camera_.width - 1);
    for (int pair = first; 2 * pair <= last; ++pair) covered_[static_cast<std::size_t>(pair)] = 1;
  }

  run_ = {-1, {0, top, 0, bottom}};
  const double cell_width = static_cast<double>(camera_.width) / kCells;
  for (int cell = 0; cell < kCells; ++cell) {
    const int left = sketch_.place(cell);
    const int right = sketch_.place(cell + 1);
    if (left == right && left == run_.tile) continue;
    if (left == right && left != WallSketch::kUnsure) {
      enter(std::max(left, -1), cell * cell_width);
    } else if (const auto border = sketch_.border(cell, cell_width)) {
      enter(std::max(left, -1), cell * cell_width);
      enter(std::max(right, -1), (cell + *border) * cell_width);
    } else {
      cut_exactly(band * (kCells + 1) + cell, field_from_camera, wall);
    }
  }
  enter(-1, camera_.width);
}

void PerceivedTiles::enter(int tile, double x) {
  if (tile == run_.tile) return;
  const double pairs = 0.5 * x;
  const double whole = std::floor(pairs);
  const int border = 2 * static_cast<int>(pairs - whole < 0.5 ? whole : whole + 1.0);
  run_.pixels.right = std::min(border, camera_.width & ~1);
  if (run_.tile >= 0 && run_.pixels.right > run_.pixels.left) add_block(run_);
  run_.pixels.left = std::max(run_.pixels.right, 0);
  run_.tile = tile;
}

/// The cell to the right of a ray.
void PerceivedTiles::cut_exactly(int ray, const Isometry3& field_from_camera, const Wall& wall) {
  const int cell = ray % (kCells + 1);
  const double cell_width = static_cast<double>(camera_.width) / kCells;
  std::array<Eigen::Vector3d, 2> directions;
  std::array<std::optional<WallPoint>, 2> borders;
  for (std::size_t i = 0; i < 2; ++i)
    directions[i] = field_from_camera.linear() * rays_[static_cast<std::size_t>(ray) + i];
  wall.meet(field_from_camera.translation(), directions, borders);
  const auto& [left, right] = borders;
  constexpr double kSteepest = 64.0;  // rows across one cell; steeper views along the wall are not interpolated
  const bool misses = !left || !right || std::max(left->row, right->row) < 0.0 ||
                      std::min(left->row, right->row) >= wall.rows() || std::abs(left->row - right->row) > kSteepest;
  if (misses) return enter(-1, cell * cell_width);
  // Unwrapped, so that interpolation uses the shorter arc.
  const double right_column = left->column + std::remainder(right->column - left->column, wall.columns());
  double t = 0.0;
  while (t < 1.0) {
    const double end = std::min(next_crossing(left->column, right_column, t), next_crossing(left->row, right->row, t));
    const double middle = 0.5 * (t + end);
    const double row = left->row + middle * (right->row - left->row);
    int column = static_cast<int>(std::floor(left->column + middle * (right_column - left->column))) % wall.columns();
    if (column < 0) column += wall.columns();
    enter(row < 0.0 || row >= wall.rows() ? -1 : wall.tile(static_cast<int>(row), column), (cell + t) * cell_width);
    t = end > t ? end : 1.0;
  }
}

void PerceivedTiles::add_block(const TileBlock& block) {
  const auto add = [&](int left, int right) {
    blocks_.push_back({block.tile, {left, block.pixels.top, right, block.pixels.bottom}});
    counts_[static_cast<std::size_t>(block.tile)].area +=
        static_cast<double>(right - left) * (block.pixels.bottom - block.pixels.top);
  };
  if (!any_covered_) return add(block.pixels.left, block.pixels.right);
  int left = block.pixels.left;
  for (int x = block.pixels.left; x <= block.pixels.right; x += 2) {
    const bool ends = x >= block.pixels.right || covered_[static_cast<std::size_t>(x / 2)] != 0;
    if (!ends) continue;
    if (x > left) add(left, std::min(x, block.pixels.right));
    left = x + 2;
  }
}

/// Position in the image of a corner of a tile, or of the middle of an edge. Adjacent tiles share them.
const std::optional<Eigen::Vector2d>& PerceivedTiles::outline_point(int half_column, int row, const CameraModel& camera,
                                                                    const Isometry3& camera_from_field,
                                                                    const Wall& wall) {
  OutlinePoint& point = outline_[static_cast<std::size_t>(row * (2 * wall.columns() + 1) + half_column)];
  if (!point.known) point = {true, camera.project(camera_from_field * wall.point(0.5 * half_column, row))};
  return point.pixel;
}

/// The area of a tile in the image, including the part beyond the image's borders: a hexagon, since the upper and lower
/// edges are arcs.
double PerceivedTiles::projected_area(int tile, const CameraModel& camera, const Isometry3& camera_from_field,
                                      const Wall& wall) {
  constexpr std::size_t kPoints = 6;
  constexpr int kHalfColumn[kPoints] = {0, 1, 2, 2, 1, 0};
  constexpr int kRow[kPoints] = {0, 0, 0, 1, 1, 1};
  Eigen::Vector2d outline[kPoints];
  for (std::size_t i = 0; i < kPoints; ++i) {
    const auto& pixel = outline_point(2 * wall.column_of(tile) + kHalfColumn[i], wall.row_of(tile) + kRow[i], camera,
                                      camera_from_field, wall);
    if (!pixel) return 0.0;
    outline[i] = *pixel;
  }
  double twice = 0.0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % kPoints];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

void PerceivedTiles::measure(const Isometry3& field_from_camera, const CameraModel& camera, const Wall& wall) {
  const Isometry3 camera_from_field = field_from_camera.inverse();
  outline_.assign(static_cast<std::size_t>((wall.rows() + 1) * (2 * wall.columns() + 1)), {});
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    const TileCount& count = counts_[static_cast<std::size_t>(tile)];
    if (count.area <= 0.0) continue;
    PerceivedTile perceived;
    perceived.tile = tile;
    perceived.area = count.area;
    perceived.expected_area = projected_area(tile, camera, camera_from_field, wall);
    const Eigen::Vector3d sight = wall.center(tile) - field_from_camera.translation();
    perceived.distance = sight.norm();
    perceived.incidence = perceived.distance > 0.0 ? sight.dot(wall.normal(tile)) / perceived.distance : 0.0;
    tiles_.push_back(perceived);
  }
}

void PerceivedTiles::blur(double share) {
  for (PerceivedTile& tile : tiles_) {
    tile.histogram = blurred(tile.histogram, share);
    tile.reflected_histogram = blurred(tile.reflected_histogram, share);
  }
}

std::span<const TileLight> PerceivedTiles::light(const ImageView& image, const LightParameters& parameters,
                                                 const PerceptionParameters& perception) {
  for (const TileBlock& block : blocks_) {
    const int middle = (block.pixels.top + block.pixels.bottom) / 2;
    counts_[static_cast<std::size_t>(block.tile)].light +=
        sum_light(image, middle, block.pixels.left, block.pixels.right, parameters);
  }
  lights_.clear();
  for (const PerceivedTile& tile : tiles_) {
    if (tile.coverage() < perception.min_learned_coverage) continue;
    lights_.push_back({tile.tile, counts_[static_cast<std::size_t>(tile.tile)].light});
  }
  return lights_;
}

void PerceivedTiles::count(const ImageView& image, const ColorThresholds& if_believed,
                           const ColorThresholds& if_reflected, const PerceptionParameters& parameters) {
  const bool both = if_reflected != if_believed;
  const int step = row_step(image.height, parameters);
  for (const TileBlock& block : blocks_) {
    // Every step-th row of the image, independent of its band.
    PixelBlock sampled = block.pixels;
    sampled.top = (block.pixels.top + step - 1) / step * step;
    TileCount& count = counts_[static_cast<std::size_t>(block.tile)];
    count_colors(image, sampled, step, if_believed, count.colors);
    if (both) count_colors(image, sampled, step, if_reflected, count.reflected_colors);
  }
  for (PerceivedTile& tile : tiles_) {
    const TileCount& count = counts_[static_cast<std::size_t>(tile.tile)];
    tile.samples = 0;
    for (const std::uint32_t color : count.colors) tile.samples += static_cast<int>(color);
    tile.histogram = normalized(count.colors);
    tile.reflected_histogram = both ? normalized(count.reflected_colors) : tile.histogram;
    tile.counts = tile.samples >= std::max(parameters.min_samples, 1) && tile.expected_area > 0.0 &&
                  tile.coverage() >= parameters.min_coverage && tile.distance > parameters.min_distance &&
                  tile.incidence > parameters.min_incidence;
  }
}

}  // namespace reorient
