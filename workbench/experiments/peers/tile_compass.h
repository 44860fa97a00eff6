// SPDX-License-Identifier: MIT
// Color histograms on tiles around the robot, on any wall: the observation of a tile is compared with the
// tile and with the one rotated by 180 degrees. So walls are compared by the same rule.
#pragma once

#include <span>
#include <vector>

#include "perception/room/color/color_histogram.h"
#include "perception/room/color/histogram_distance.h"
#include "workbench/experiments/peers/color_classes.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

/// What one frame shows of a tile.
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

/// Learned is each tile's mean histogram. Compared is how far each tile in view is from its own and from its
/// reflection's; the sum over tiles and frames is the score.
class TileCompass : public OrientationCompass {
 public:
  void learn(const RoomObservation& view) override;
  void begin() override { score_ = 0.0; }
  double compare(const RoomObservation& view) override;

 protected:
  TileCompass(int tiles, const TileCompassParameters& parameters)
      : parameters_(parameters), tiles_(static_cast<std::size_t>(tiles)) {}

  /// The tiles that one frame shows well enough; valid until the next call.
  virtual std::span<const SeenTile> look(const RoomObservation& view) = 0;
  virtual int reflected(int tile) const = 0;

  /// One pixel on a tile. All of a frame, then the thresholds that follow the tiles' light.
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
