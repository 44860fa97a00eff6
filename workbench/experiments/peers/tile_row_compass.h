// Colour histograms on a single row of tiles around the field, after Bader et al. 2012, the predecessor of the paper's
// wall. docs/peers.md says what was known of it.
#pragma once

#include <vector>

#include "perception/room/color/color_histogram.h"
#include "perception/room/color/histogram_distance.h"
#include "perception/room/wall/perceived_tiles.h"
#include "perception/room/wall/wall.h"
#include "workbench/experiments/peers/color_classes.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

struct TileRowCompassParameters {
  int columns = 48;
  double bottom = 0.7;
  double top = 2.0;
  double radius = 8.0;
  double light_memory = 20.0;
  DistanceParameters distance{Distance::hellinger, 0.5};
};
template <typename Visit>
void describe(TileRowCompassParameters& p, Visit&& visit) {
  visit("columns", p.columns, 4, 128, "", "tiles around the field; made even");
  visit("bottom", p.bottom, 0.0, 10.0, "m", "height where the tiles begin");
  visit("top", p.top, 0.1, 30.0, "m", "height where the tiles end");
  visit("radius", p.radius, 6.0, 100.0, "m", "distance of the tiles from the field's centre");
  visit("light_memory", p.light_memory, 0.0, 600.0, "s",
        "over how long the tiles' mean colour runs, which the thresholds follow; 0: they are fixed");
  describe(p.distance, visit);
}

/// Learned is each tile's mean histogram. Compared is how far each tile in view is from its own and from its
/// reflection's.
class TileRowCompass : public OrientationCompass {
 public:
  explicit TileRowCompass(const TileRowCompassParameters& parameters = {});

  void learn(const RoomObservation& view) override;
  void begin() override { score_ = 0.0; }
  double compare(const RoomObservation& view) override;
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<TileRowCompass>(*this); }

 private:
  struct Tile {
    ColorHistogram mean{};
    int seen = 0;  // frames
  };

  void look(const RoomObservation& view);

  TileRowCompassParameters parameters_;
  Wall wall_;
  std::vector<Tile> tiles_;
  RunningLight light_;
  PerceivedTiles perceived_;
  double score_ = 0.0;
};

}  // namespace reorient
