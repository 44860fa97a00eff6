// SPDX-License-Identifier: MIT
// Tiles on a cylinder: a single row of them, after Bader et al. 2012, the predecessor of the paper's wall
// (docs/peers.md lists what is known of it), or several, as the paper has it.
#pragma once

#include <vector>

#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"
#include "workbench/experiments/peers/tile_compass.h"

namespace reorient {

struct TileRowCompassParameters {
  int rows = 1;
  int columns = 48;
  double bottom = 0.7;
  double top = 2.0;
  double radius = 8.0;
  TileCompassParameters tiles{};
};
template <typename Visit>
void describe(TileRowCompassParameters& p, Visit&& visit) {
  visit("rows", p.rows, 1, 8, "", "number of rows of tiles");
  visit("columns", p.columns, 4, 128, "", "number of tiles around the field, rounded to an even number");
  visit("bottom", p.bottom, 0.0, 10.0, "m", "height of the lower edge of the lowest tiles");
  visit("top", p.top, 0.1, 30.0, "m", "height of the upper edge of the highest tiles");
  visit("radius", p.radius, 6.0, 100.0, "m", "distance of the tiles from the center of the field");
  describe(p.tiles, visit);
}

class TileRowCompass : public TileCompass {
 public:
  explicit TileRowCompass(const TileRowCompassParameters& parameters = {});
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<TileRowCompass>(*this); }

 private:
  std::span<const SeenTile> look(const RoomObservation& view) override;
  int reflected(int tile) const override { return wall_.reflected(tile); }

  TileRowCompassParameters parameters_;
  Wall wall_;
  PerceivedTiles perceived_;
  std::vector<SeenTile> seen_;
};

}  // namespace reorient
