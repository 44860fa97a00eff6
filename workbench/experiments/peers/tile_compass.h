// SPDX-License-Identifier: MIT
// Color histograms on tiles around the robot, on any wall: compares the observation of a tile with the tile and with
// the one rotated by 180 degrees. So walls are compared by the same rule.
#pragma once

#include <span>
#include <vector>

#include "perception/room/color/color_histogram.h"
#include "perception/room/color/histogram_distance.h"
#include "workbench/experiments/peers/color_classes.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

/// The observation of a tile in one frame.
struct SeenTile {
  int tile = 0;
  ColorHistogram histogram{};
};

struct TileCompassParameters {
  double light_memory = 20.0;
  DistanceParameters distance{Distance::hellinger, 0.5};
};
template <typename Visit>
void describe(TileCompassParameters& p, Visit&& visit) {
  visit("light_memory", p.light_memory, 0.0, 600.0, "s",
        "time constant of the mean color of the tiles, which the thresholds follow; 0: fixed thresholds");
  describe(p.distance, visit);
}

/// It learns each tile's mean histogram. It compares the distance of each tile in view from its own mean and from that
/// of its reflection; the sum over tiles and frames is the score.
class TileCompass : public OrientationCompass {
 public:
  void learn(const RoomObservation& view) override;
  void begin() override { score_ = 0.0; }
  double compare(const RoomObservation& view) override;

 protected:
  TileCompass(int tiles, const TileCompassParameters& parameters)
      : parameters_(parameters), tiles_(static_cast<std::size_t>(tiles)) {}

  /// The tiles that are sufficiently in view in one frame; valid until the next call.
  virtual std::span<const SeenTile> look(const RoomObservation& view) = 0;
  virtual int reflected(int tile) const = 0;

  /// Adds one pixel on a tile. After all pixels of a frame, the thresholds follow the tiles' light.
  void add_light(const Ycbcr& color) { light_.add(color); }
  ColorThresholds next_thresholds(double time);

 private:
  struct LearnedTile {
    ColorHistogram mean{};
    int seen = 0;  // frames
  };

  TileCompassParameters parameters_;
  RunningLight light_;
  std::vector<LearnedTile> tiles_;
  double score_ = 0.0;
};

}  // namespace reorient
