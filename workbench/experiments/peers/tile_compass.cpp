// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/tile_compass.h"

#include <algorithm>

namespace reorient {

void TileCompass::learn(const RoomObservation& view) {
  for (const SeenTile& seen : look(view)) {
    LearnedTile& tile = tiles_[static_cast<std::size_t>(seen.tile)];
    const auto share = 1.0f / static_cast<float>(++tile.seen);
    for (std::size_t i = 0; i < tile.mean.size(); ++i) tile.mean[i] += share * (seen.histogram[i] - tile.mean[i]);
  }
}

double TileCompass::compare(const RoomObservation& view) {
  constexpr int kLeastSeen = 10;  // frames after which a tile is used
  for (const SeenTile& seen : look(view)) {
    const LearnedTile& here = tiles_[static_cast<std::size_t>(seen.tile)];
    const LearnedTile& there = tiles_[static_cast<std::size_t>(reflected(seen.tile))];
    if (here.seen < kLeastSeen || there.seen < kLeastSeen) continue;
    const auto difference = [&](const LearnedTile& tile) {
      return std::min(parameters_.distance.cap, distance(parameters_.distance.measure, seen.histogram, tile.mean));
    };
    score_ += difference(here) - difference(there);
  }
  return score_;
}

ColorThresholds TileCompass::next_thresholds(double time) {
  light_.next_frame(time, parameters_.light_memory);
  return color_thresholds({}, light_.is_known() ? Light{light_.luma(), light_.cb(), light_.cr()} : Light{});
}

}  // namespace reorient
