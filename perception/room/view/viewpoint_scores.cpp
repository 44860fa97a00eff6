#include "perception/room/view/viewpoint_scores.h"

#include <algorithm>
#include <cmath>

namespace reorient {

void ComparedModel::prepare(const BackgroundModel& model, const Comparison& comparison) {
  const std::span<const TileModel> tiles = model.tiles();
  tiles_.resize(tiles.size());
  trusted_.resize(tiles.size());
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    trusted_[i] = tiles[i].visits > 0 && tiles[i].trained >= comparison.trusted_after ? 1 : 0;
    tiles_[i] = prepared(comparison.measure, tiles[i].mean);
  }
}

double ComparedModel::coverage() const {
  if (trusted_.empty()) return 0.0;
  const auto trusted = std::count(trusted_.begin(), trusted_.end(), 1);
  return static_cast<double>(trusted) / static_cast<double>(trusted_.size());
}

void ViewpointScores::clear() {
  cells_.clear();
  best_ = 0;
  average_ = 0.0;
  evidence_ = false;
}

void ViewpointScores::compute(std::span<const PerceivedTile> perceived, const ComparedModel& model, const Wall& wall,
                              const Comparison& comparison) {
  perceived_.clear();
  places_.clear();
  perceived_.reserve(static_cast<std::size_t>(wall.tiles()));
  places_.reserve(static_cast<std::size_t>(wall.tiles()));
  for (const PerceivedTile& tile : perceived) {
    if (!tile.counts) continue;
    perceived_.push_back(prepared(comparison.measure, tile.histogram));
    places_.push_back(tile.tile);
  }
  const int columns = wall.columns();
  cells_.assign(static_cast<std::size_t>(columns), ViewpointScore{});
  constexpr int kFewest = 2;  // tiles
  const int enough = std::max(kFewest, (static_cast<int>(places_.size()) + 1) / 2);
  double known_distance = 0.0;
  int known = 0;
  for (int turn = 0; turn < columns; ++turn) {
    ViewpointScore& cell = cells_[static_cast<std::size_t>(turn)];
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const int column = wall.column_of(places_[i]) + turn;
      const int tile = wall.tile(wall.row_of(places_[i]), column < columns ? column : column - columns);
      if (!model.trusted(tile)) continue;
      cell.distance += std::min(comparison.cap, reorient::distance(comparison.measure, perceived_[i], model[tile]));
      ++cell.compared;
    }
    cell.known = cell.compared >= enough;
    if (!cell.known) continue;
    cell.distance /= cell.compared;
    known_distance += cell.distance;
    ++known;
  }
  // What nothing is known about is neither better nor worse than the rest.
  average_ = known > 0 ? known_distance / known : 0.0;
  for (ViewpointScore& cell : cells_) {
    if (!cell.known) cell.distance = average_;
  }
  const auto best =
      std::min_element(cells_.begin(), cells_.end(),
                       [](const ViewpointScore& a, const ViewpointScore& b) { return a.distance < b.distance; });
  best_ = static_cast<int>(best - cells_.begin());
  evidence_ = at(0).known && at(columns / 2).known;
}

const ViewpointScore& ViewpointScores::at(int turn) const {
  const int wrapped = turn % columns();
  return cells_[static_cast<std::size_t>(wrapped < 0 ? wrapped + columns() : wrapped)];
}

double ViewpointScores::distance(double turn) const {
  const double below = std::floor(turn);
  const double share = turn - below;
  const int cell = static_cast<int>(below);
  return (1.0 - share) * at(cell).distance + share * at(cell + 1).distance;
}

}  // namespace reorient
