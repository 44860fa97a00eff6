// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/tile_row_compass.h"

namespace reorient {
namespace {

WallParameters cylinder(const TileRowCompassParameters& parameters) {
  WallParameters wall;
  wall.radius = parameters.radius;
  wall.bottom = parameters.bottom;
  wall.top = parameters.top;
  wall.rows = parameters.rows;
  wall.columns = parameters.columns;
  return wall;
}

}  // namespace

TileRowCompass::TileRowCompass(const TileRowCompassParameters& parameters)
    : TileCompass(Wall(cylinder(parameters)).tiles(), parameters.tiles),
      parameters_(parameters),
      wall_(cylinder(parameters)) {}

std::span<const SeenTile> TileRowCompass::look(const RoomObservation& view) {
  const PerceptionParameters perception;
  perceived_.find(view, wall_, perception);
  for (const TileBlock& block : perceived_.blocks()) {
    const int y = (block.pixels.top + block.pixels.bottom) / 2;
    for (int x = block.pixels.left; x < block.pixels.right; x += 4) add_light(view.image.at(x, y));
  }
  const ColorThresholds now = next_thresholds(view.time);
  perceived_.count(view.image, now, now, perception);
  seen_.clear();
  for (const PerceivedTile& tile : perceived_.tiles()) {
    if (tile.counts) seen_.push_back({tile.tile, tile.histogram});
  }
  return seen_;
}

}  // namespace reorient
