// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/world_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/angle.h"
#include "workbench/views/pictures/parts/field_drawing.h"
#include "workbench/views/pictures/parts/histogram_bars.h"
#include "workbench/views/pictures/parts/legend.h"
#include "workbench/views/scene/field_scene.h"

namespace reorient::pictures {
namespace {

constexpr int kWorldWidth = 1500;
constexpr int kHeight = 1200;
constexpr int kRows = 6;
constexpr double kFullRing = 0.5;  // fraction of the pixels whose bar is as high as its ring

// Radii in pixels, from the inside out.
constexpr double kFieldRadius = 356.0;
constexpr double kGoalAreaInner = 358.0;
constexpr double kGoalAreaOuter = 368.0;
constexpr double kViewInner = 372.0;
constexpr double kParticles = 392.0;
constexpr double kViewOuter = 412.0;
constexpr double kModelInner = 416.0;
constexpr double kModelDepth = 88.0;
constexpr double kPerceivedInner = 510.0;
constexpr double kLeastEvidence = 0.02;  // log-odds of a tile that supports neither pose
constexpr Color kStripe{255, 255, 255, 0.75};
constexpr double kBelow = 0.3;  // fraction of a ring's depth that is for the deviations

bool drawable(const WallTile& tile) {
  const double width = tile.to - tile.from;
  return tile.row >= 0 && tile.row < kRows && width > 0.0 && width <= 2.0 * kPi && std::abs(tile.from) < 1e3;
}

// The wall, unrolled: rows of tiles are rings around the center, the lowest row is the innermost.
class Rings {
 public:
  Rings(Canvas& canvas, const Pixel& center, double inner, double depth, int rows)
      : canvas_(canvas), center_(center), inner_(inner), depth_(depth / rows) {}

  void plate(const WallTile& tile, Color color) const {
    const double foot = inner_ + tile.row * depth_, half_seam = seam(tile) / 2.0;
    canvas_.fill(ring_sector(center_, foot + 1.0, foot + depth_ - 1.5, tile.from + half_seam, tile.to - half_seam),
                 color);
  }

  /// A plate in the color of the tile's evidence. Stripes are the sign of the mirrored pose, also without colors.
  void evidence_plate(const WallTile& tile) const {
    if (!tile.evidence) return plate(tile, palette::plate);
    plate(tile, scene::evidence_color(*tile.evidence));
    if (!(*tile.evidence >= kLeastEvidence)) return;
    const double foot = inner_ + tile.row * depth_ + 1.0, head = foot + depth_ - 2.5, half_seam = seam(tile) / 2.0;
    constexpr int kStripes = 3;
    const double step = (tile.to - tile.from - 2.0 * half_seam) / (kStripes + 1);
    for (int i = 0; i < kStripes; ++i) {
      const double from = tile.from + half_seam + (i + 0.5) * step;
      canvas_.line(at(from, foot), at(from + step, head), kStripe, 2.0);
    }
  }

  void bars(const WallTile& tile, double below) const {
    const double foot = inner_ + tile.row * depth_ + 2.0;
    const double height = depth_ - 5.0;
    const double margin = 0.1 * (tile.to - tile.from);
    const auto place = [&](double along, double up) -> Pixel {
      const double base = foot + below * height;
      const double radius = base + up * (up > 0.0 ? (1.0 - below) * height : below * height);
      // The first bin is at the left as seen from the center.
      const double angle = tile.to - margin + along * (tile.from - tile.to + 2.0 * margin);
      return at(angle, radius);
    };
    draw_histogram(canvas_, tile.histogram, place, kFullRing);
  }

 private:
  static double seam(const WallTile& tile) { return std::min(0.06 * (tile.to - tile.from), 4.0 / kModelInner); }
  Pixel at(double angle, double radius) const { return center_ + radius * Pixel(std::cos(angle), -std::sin(angle)); }

  Canvas& canvas_;
  Pixel center_;
  double inner_;
  double depth_;
};

int rows_of(const WorldView& world) {
  int rows = 1;
  for (const auto* tiles : {&world.model, &world.untrained, &world.perceived})
    for (const WallTile& tile : *tiles)
      if (drawable(tile)) rows = std::max(rows, tile.row + 1);
  return rows;
}

void draw_wall(Canvas& canvas, const Pixel& center, const WorldView& world) {
  const int rows = rows_of(world);
  const Rings wall(canvas, center, kModelInner, kModelDepth, rows);
  for (const WallTile& tile : world.untrained)
    if (drawable(tile)) wall.plate(tile, palette::empty_plate);
  for (const WallTile& tile : world.model) {
    if (!drawable(tile)) continue;
    wall.plate(tile, palette::plate);
    wall.bars(tile, kBelow);
  }
  const Rings perceived(canvas, center, kPerceivedInner, kModelDepth * (1.0 - kBelow), rows);
  for (const WallTile& tile : world.perceived) {
    if (!drawable(tile)) continue;
    perceived.evidence_plate(tile);
    perceived.bars(tile, 0.0);
  }
}

void draw_view_sector(Canvas& canvas, const Pixel& center, double azimuth, double half_width, Color color) {
  const double from = azimuth - half_width;
  const double to = azimuth + half_width;
  const std::vector<Pixel> sector = ring_sector(center, kViewInner, kViewOuter, from, to);
  canvas.fill(sector, color.with_opacity(0.2));
  canvas.polyline(sector, color.with_opacity(0.85), 1.5, true);
}

// The sectors whose particles count (the paper's Section 3.4), and the view from the robot to the wall.
void draw_sectors(Canvas& canvas, const FieldView& view, const WorldView& world) {
  if (world.goal_area_half_width > 0.0) {
    for (const double middle : {0.0, kPi}) {
      const double half = std::min(world.goal_area_half_width, kPi / 2.0);
      canvas.fill(ring_sector(view.center, kGoalAreaInner, kGoalAreaOuter, middle - half, middle + half),
                  palette::goal_area);
    }
  }
  if (!world.view_azimuth || !(world.view_half_width > 0.0)) return;
  const double half = std::min(world.view_half_width, kPi / 2.0);
  const double azimuth = *world.view_azimuth;
  draw_view_sector(canvas, view.center, azimuth, half, palette::belief);
  draw_view_sector(canvas, view.center, azimuth + kPi, half, palette::opposite);
  if (!world.belief) return;
  const Pixel robot = view * world.belief->position;
  for (const double side : {-half, half}) {
    const double angle = azimuth + side;
    const Pixel end = view.center + kViewInner * Pixel(std::cos(angle), -std::sin(angle));
    canvas.dashed_line(robot, end, palette::belief.with_opacity(0.55), 1.0, 7.0);
  }
}

void draw_view_cells(Canvas& canvas, const Pixel& center, const WorldView& world) {
  for (const ViewCell& cell : world.view_cells) {
    if (!(cell.share > 0.0 && cell.share <= 1.0 && cell.to > cell.from && cell.to - cell.from <= 2.0 * kPi)) continue;
    const double foot = kViewInner + 2.0;
    const double height = (kViewOuter - kViewInner - 4.0) * std::sqrt(cell.share);
    canvas.fill(ring_sector(center, foot, foot + height, cell.from, cell.to), palette::view_particle);
  }
}

void draw_view_particles(Canvas& canvas, const Pixel& center, const WorldView& world) {
  for (const ViewCluster& cluster : world.view_clusters) {
    if (!(cluster.spread >= 0.0)) continue;
    const double along = std::clamp(2.0 * cluster.spread * kParticles, 16.0, 0.5 * kPi * kParticles);
    const Pixel middle = center + kParticles * Pixel(std::cos(cluster.azimuth), -std::sin(cluster.azimuth));
    if (along < 70.0) {
      canvas.ellipse(middle, {along, 19.0}, cluster.azimuth + kPi / 2.0, palette::cluster, 3.0);
    } else {  // an ellipse would extend beyond the ring
      const double half = along / kParticles;
      canvas.polyline(
          ring_sector(center, kParticles - 19.0, kParticles + 19.0, cluster.azimuth - half, cluster.azimuth + half),
          palette::cluster, 3.0, true);
    }
  }
  // Particles differ only in azimuth. Spreading them over the ring's depth by the golden ratio keeps them countable.
  double depth = 0.5;
  for (const double azimuth : world.view_particles) {
    depth = std::fmod(depth + 0.6180339887498949, 1.0);
    const double radius = kParticles + 26.0 * (depth - 0.5);
    canvas.disc(center + radius * Pixel(std::cos(azimuth), -std::sin(azimuth)), 3.1, palette::view_particle);
  }
}

std::vector<LegendEntry> entries(const WorldView& world, std::span<const scene::PoseLayer> poses) {
  std::vector<LegendEntry> list = pose_entries(poses);
  if (!world.view_particles.empty()) list.push_back(dot_entry(palette::view_particle, 4.0, "view particles"));
  if (!world.view_cells.empty()) list.push_back(patch_entry(palette::view_particle, "view cells"));
  if (!world.view_clusters.empty()) {
    list.push_back({[](Canvas& canvas, const Pixel& center) {
                      canvas.ellipse(center, {15.0, 8.0}, 0.0, palette::cluster, 3.0);
                    },
                    "their clusters"});
  }
  if (world.view_azimuth) {
    list.push_back(patch_entry(palette::belief.with_opacity(0.35), "believed view"));
    list.push_back(patch_entry(palette::opposite.with_opacity(0.35), "view if mirrored"));
  }
  if (world.goal_area_half_width > 0.0) list.push_back(patch_entry(palette::goal_area, "goal view areas"));
  return list;
}

/// The colors of the perceived tiles, of those that are drawn.
void draw_evidence_legend(Canvas& canvas, const std::vector<WallTile>& tiles) {
  bool believed = false, mirrored = false, neither = false;
  for (const WallTile& tile : tiles) {
    if (!drawable(tile) || !tile.evidence) continue;
    const bool is_clear = std::abs(*tile.evidence) >= kLeastEvidence;
    believed |= is_clear && *tile.evidence < 0.0;
    mirrored |= is_clear && *tile.evidence > 0.0;
    neither |= !is_clear;
  }
  std::vector<LegendEntry> list;
  const double full = scene::kFullEvidence;
  if (believed) list.push_back(patch_entry(scene::evidence_color(-full), "the believed pose"));
  if (mirrored) {
    const auto striped = [full](Canvas& surface, const Pixel& center) {
      surface.fill_box({center.x() - 15.0, center.y() - 8.0, 30.0, 16.0}, scene::evidence_color(full));
      for (const double x : {-12.0, -4.0, 4.0})
        surface.line(center + Pixel(x, 7.0), center + Pixel(x + 8.0, -7.0), kStripe, 2.0);
    };
    list.push_back({striped, "the mirrored pose"});
  }
  if (neither) list.push_back(patch_entry(palette::no_evidence, "neither"));
  if (list.empty()) return;
  canvas.text({1234.0, 54.0}, "Tiles in view match", {.size = 21.0, .bold = true});
  draw_legend_column(canvas, {1230.0, 68.0}, list);
}

void draw_chart_legend(Canvas& canvas, bool any_perceived) {
  const double left = 1226.0;
  const double top = 988.0;
  canvas.text({left, top}, "Color histograms", {.size = 21.0, .bold = true});
  draw_bin_legend(canvas, {left, top + 18.0});
  const TextStyle small{.size = 16.0, .color = palette::faint_ink};
  char words[64];
  std::snprintf(words, sizeof words, "fraction outward, full %.0f %%", 100.0 * kFullRing);
  canvas.text({left, top + 138.0}, words, small);
  std::snprintf(words, sizeof words, "deviation inward, full %.1f %%", 25.0 * kFullRing);
  canvas.text({left, top + 160.0}, words, small);
  if (any_perceived) canvas.text({left, top + 182.0}, "outer ring: current image", small);
}

}  // namespace

Picture draw_world_view(const WorldView& world) {
  Canvas canvas(kWorldWidth, kHeight);
  const Pixel center(kWorldWidth / 2.0, kHeight / 2.0);
  const double half_diagonal = carpet_half_size(world.field).norm();
  const double scale = std::min(kFieldRadius / half_diagonal, kModelInner / world.wall_radius);
  const FieldView view{center, std::isfinite(scale) && scale > 0.0 ? scale : 1.0};

  draw_wall(canvas, center, world);
  draw_field(canvas, view, world.field);
  draw_sectors(canvas, view, world);
  draw_view_cells(canvas, center, world);
  draw_view_particles(canvas, center, world);
  const std::vector<scene::PoseLayer> poses = scene::pose_layers(world.pose_particles, world.truth, world.belief);
  draw_poses(canvas, view, poses);
  const double field_bottom = carpet_half_size(world.field).y() * view.pixels_per_meter;
  draw_scale_bar(canvas, view, center + Pixel(0.0, std::clamp(field_bottom + 44.0, 60.0, 310.0)), palette::ink);

  const TextStyle bold{.size = 28.0, .bold = true};
  canvas.text({36.0, 58.0}, shortened(world.title, 440.0, bold), bold);
  const TextStyle plain{.size = 20.0, .color = palette::faint_ink};
  if (world.time) {
    char time[48];
    std::snprintf(time, sizeof time, "at %.1f s", *world.time);
    canvas.text({36.0, 92.0}, time, plain);
  }
  canvas.text({36.0, 120.0}, shortened(world.note, 380.0, plain), plain);
  const std::vector<LegendEntry> list = entries(world, poses);
  draw_legend_column(canvas, {36.0, kHeight - 40.0 - 30.0 * static_cast<double>(list.size())}, list);
  draw_evidence_legend(canvas, world.perceived);
  draw_chart_legend(canvas, std::any_of(world.perceived.begin(), world.perceived.end(), drawable));
  return canvas.finish();
}

}  // namespace reorient::pictures
