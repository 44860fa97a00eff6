// SPDX-License-Identifier: MIT
#include "perception/room/compared_model.h"

#include <algorithm>

namespace reorient {

void ComparedModel::prepare(const BackgroundModel& model, const Wall& wall, const Comparison& comparison) {
  const std::span<const TileModel> learned = model.tiles();
  if (tiles_.size() != learned.size() || comparison != comparison_) tiles_.assign(learned.size(), Tile{});
  comparison_ = comparison;
  bool any = false;
  for (std::size_t i = 0; i < learned.size(); ++i) {
    Tile& tile = tiles_[i];
    if (tile.visits == learned[i].visits && tile.trained == learned[i].trained) continue;
    any = true;
    tile.visits = learned[i].visits;
    tile.trained = learned[i].trained;
    tile.trusted = learned[i].is_trained_for(comparison.trusted_after);
    tile.histogram = prepared(comparison.measure, learned[i].mean);
    tile.roots = prepared(Distance::hellinger, learned[i].mean);
    const auto other = static_cast<std::size_t>(wall.reflected(static_cast<int>(i)));
    tile.reflection_trained = learned[other].trained;
    tiles_[other].reflection_trained = tile.trained;
    std::optional<double> difference;
    if (tile.trusted && tiles_[other].trusted)
      difference = this->difference(static_cast<int>(i), static_cast<int>(other));
    tile.difference = tiles_[other].difference = difference;
  }
  if (any) summarize(wall);
}

void ComparedModel::summarize(const Wall& wall) {
  double sum = 0.0;
  int trusted = 0;
  int pairs = 0;
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    if (this->trusted(tile)) ++trusted;
    if (const std::optional<double> difference = difference_to_reflection(tile)) {
      sum += *difference;
      ++pairs;
    }
  }
  coverage_ = static_cast<double>(trusted) / wall.tiles();
  paired_ = static_cast<double>(pairs) / wall.tiles();
  distinctiveness_ = pairs > 0 ? sum / pairs : 0.0;
}

}  // namespace reorient
