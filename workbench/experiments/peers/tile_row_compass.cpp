#include "workbench/experiments/peers/tile_row_compass.h"

#include <algorithm>

namespace reorient {
namespace {

constexpr int kLeastSeen = 10;  // frames after which a tile is compared with

Wall single_row(const TileRowCompassParameters& parameters) {
  WallParameters wall;
  wall.radius = parameters.radius;
  wall.bottom = parameters.bottom;
  wall.top = parameters.top;
  wall.rows = 1;
  wall.columns = parameters.columns;
  return Wall(wall);
}

}  // namespace

TileRowCompass::TileRowCompass(const TileRowCompassParameters& parameters)
    : parameters_(parameters), wall_(single_row(parameters)), tiles_(static_cast<std::size_t>(wall_.tiles())) {}

void TileRowCompass::look(const RoomObservation& view) {
  const PerceptionParameters perception;
  perceived_.find(view, wall_, perception);
  for (const TileBlock& block : perceived_.blocks()) {
    const int y = (block.pixels.top + block.pixels.bottom) / 2;
    for (int x = block.pixels.left; x < block.pixels.right; x += 4) light_.add(view.image.at(x, y));
  }
  light_.next_frame(view.time, parameters_.light_memory);
  const Light light = light_.is_known() ? Light{light_.luma(), light_.cb(), light_.cr()} : Light{};
  const ColorThresholds thresholds = color_thresholds({}, light);
  perceived_.count(view.image, thresholds, thresholds, perception);
}

void TileRowCompass::learn(const RoomObservation& view) {
  look(view);
  for (const PerceivedTile& perceived : perceived_.tiles()) {
    if (!perceived.counts) continue;
    Tile& tile = tiles_[static_cast<std::size_t>(perceived.tile)];
    const auto share = 1.0f / static_cast<float>(++tile.seen);
    for (std::size_t i = 0; i < tile.mean.size(); ++i) tile.mean[i] += share * (perceived.histogram[i] - tile.mean[i]);
  }
}

double TileRowCompass::compare(const RoomObservation& view) {
  look(view);
  for (const PerceivedTile& perceived : perceived_.tiles()) {
    const Tile& here = tiles_[static_cast<std::size_t>(perceived.tile)];
    const Tile& there = tiles_[static_cast<std::size_t>(wall_.reflected(perceived.tile))];
    if (!perceived.counts || here.seen < kLeastSeen || there.seen < kLeastSeen) continue;
    const auto difference = [&](const Tile& tile) {
      return std::min(parameters_.distance.cap, distance(parameters_.distance.measure, perceived.histogram, tile.mean));
    };
    score_ += difference(here) - difference(there);
  }
  return score_;
}

}  // namespace reorient
