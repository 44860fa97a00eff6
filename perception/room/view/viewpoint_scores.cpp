#include "perception/room/view/viewpoint_scores.h"

#include <algorithm>
#include <cmath>

namespace reorient {

void ViewpointScores::clear() {
  cells_.clear();
  places_.clear();
  best_ = 0;
  average_ = 0.0;
  evidence_ = false;
}

void ViewpointScores::compute(std::span<const PerceivedTile> perceived, const ComparedModel& model, const Wall& wall,
                              const Comparison& comparison) {
  const int columns = wall.columns();
  cells_.assign(static_cast<std::size_t>(columns), ViewpointScore{});
  places_.clear();
  places_.reserve(static_cast<std::size_t>(wall.tiles()));
  int counting = 0;
  for (const PerceivedTile& tile : perceived) {
    if (!tile.counts) continue;
    ++counting;
    compare({tile.tile, prepared(comparison.measure, tile.histogram),
             prepared(comparison.measure, tile.reflected_histogram)},
            model, wall, comparison);
  }
  constexpr int kFewest = 2;  // tiles
  const int enough = std::max(kFewest, (counting + 1) / 2);
  double known_distance = 0.0;
  int known = 0;
  for (ViewpointScore& cell : cells_) {
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

/// One perceived tile with the whole of its row.
void ViewpointScores::compare(const Perceived& perceived, const ComparedModel& model, const Wall& wall,
                              const Comparison& comparison) {
  const int columns = wall.columns();
  const int row = wall.row_of(perceived.tile);
  ComparedPlace place;
  place.tile = perceived.tile;
  bool any_known = false;
  for (int turn = 0; turn < columns; ++turn) {
    const int column = wall.column_of(perceived.tile) + turn;
    const int tile = wall.tile(row, column < columns ? column : column - columns);
    if (!model.trusted(tile)) continue;
    const bool is_behind = 4 * turn > columns && 4 * turn < 3 * columns;
    const double distance = reorient::distance(
        comparison.measure, is_behind ? perceived.reflected_histogram : perceived.histogram, model[tile]);
    ViewpointScore& cell = cells_[static_cast<std::size_t>(turn)];
    cell.distance += std::min(comparison.cap, distance);
    ++cell.compared;
    any_known = true;
    if (turn == 0) {
      place.as_believed = distance;
      place.believed_known = true;
    }
    if (2 * turn == columns) {
      place.as_reflected = distance;
      place.reflected_known = true;
    }
  }
  if (any_known) places_.push_back(place);
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
