// SPDX-License-Identifier: MIT
// Tiles on a half icosahedron that covers the ceiling: the wall that the paper considered but did not use.
#pragma once

#include <vector>

#include "workbench/experiments/peers/tile_compass.h"
#include "workbench/experiments/peers/triangle_dome.h"

namespace reorient {

struct DomeCompassParameters {
  double radius = 10.0;
  double bottom = 0.7;
  int cuts = 4;
  int samples = 60;
  int least_samples = 8;
  TileCompassParameters tiles{};
};
template <typename Visit>
void describe(DomeCompassParameters& p, Visit&& visit) {
  visit("radius", p.radius, 8.0, 100.0, "m", "distance of the corners of the icosahedron from the center of the field");
  visit("bottom", p.bottom, 0.0, 10.0, "m", "height of the lower edge of the lowest triangles");
  visit("cuts", p.cuts, 1, 16, "", "number of parts of each edge of a face; a face has the square of it as triangles");
  visit("samples", p.samples, 8, 640, "",
        "number of sampled pixels in a row of the image; rows have the same distance");
  visit("least_samples", p.least_samples, 1, 1000, "", "smallest number of samples in view at which a triangle counts");
  describe(p.tiles, visit);
}

class DomeCompass : public TileCompass {
 public:
  explicit DomeCompass(const DomeCompassParameters& parameters = {});
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<DomeCompass>(*this); }

 private:
  struct Sample {
    int tile = 0;
    Ycbcr color;
  };

  std::span<const SeenTile> look(const RoomObservation& view) override;
  int reflected(int tile) const override { return dome_.reflected(tile); }
  void sample(const RoomObservation& view);

  DomeCompassParameters parameters_;
  TriangleDome dome_;
  std::vector<Sample> samples_;
  std::vector<ColorCounts> counts_;  // for each tile
  std::vector<int> in_view_;         // samples of each tile
  std::vector<SeenTile> seen_;
};

}  // namespace reorient
