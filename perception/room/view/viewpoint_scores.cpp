// SPDX-License-Identifier: MIT
#include "perception/room/view/viewpoint_scores.h"

#include <algorithm>
#include <cmath>

namespace reorient {

void ViewpointScores::clear() {
  cells_.clear();
  places_.clear();
  compared_tiles_.clear();
  tile_distances_.clear();
  best_ = 0;
  average_ = 0.0;
  evidence_ = false;
}

void ViewpointScores::compute(std::span<const PerceivedTile> perceived, const ComparedModel& model, const Wall& wall,
                              const Comparison& comparison, int tolerance) {
  const int columns = wall.columns();
  const auto tiles = static_cast<std::size_t>(wall.tiles());
  cells_.assign(static_cast<std::size_t>(columns), ViewpointScore{});
  places_.reserve(tiles);
  compared_tiles_.clear();
  compared_tiles_.reserve(tiles);
  tile_distances_.clear();
  tile_distances_.reserve(tiles * cells_.size());
  turns_.reserve(cells_.size());
  models_.reserve(cells_.size());
  distances_.reserve(cells_.size());
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
  // Unknown cells get the average score, since they are neither better nor worse.
  average_ = known > 0 ? known_distance / known : 0.0;
  for (ViewpointScore& cell : cells_) {
    if (!cell.known) cell.distance = average_;
  }
  const auto best =
      std::min_element(cells_.begin(), cells_.end(),
                       [](const ViewpointScore& a, const ViewpointScore& b) { return a.distance < b.distance; });
  best_ = static_cast<int>(best - cells_.begin());
  evidence_ = at(0).known && at(columns / 2).known;
  find_places(tolerance);
}

/// The cell with the best fit of the view; of several, the nearest one.
int ViewpointScores::best_about(int turn, int tolerance) const {
  int best = turn;
  for (int aside = 1; aside <= tolerance; ++aside) {
    for (const int other : {turn - aside, turn + aside}) {
      if (at(other).known && (!at(best).known || at(other).distance < at(best).distance)) best = other;
    }
  }
  return (best + columns()) % columns();
}

void ViewpointScores::find_places(int tolerance) {
  places_.clear();
  const auto believed = static_cast<std::size_t>(best_about(0, tolerance));
  const auto reflected = static_cast<std::size_t>(best_about(columns() / 2, tolerance));
  for (std::size_t i = 0; i < compared_tiles_.size(); ++i) {
    const double* const distances = &tile_distances_[i * cells_.size()];
    ComparedPlace place;
    place.tile = compared_tiles_[i];
    place.believed_known = distances[believed] != kUnknown;
    place.reflected_known = distances[reflected] != kUnknown;
    if (place.believed_known) place.as_believed = distances[believed];
    if (place.reflected_known) place.as_reflected = distances[reflected];
    if (place.believed_known || place.reflected_known) places_.push_back(place);
  }
}

/// Compares one perceived tile with its whole row.
void ViewpointScores::compare(const Perceived& perceived, const ComparedModel& model, const Wall& wall,
                              const Comparison& comparison) {
  const int columns = wall.columns();
  const int row = wall.row_of(perceived.tile);
  turns_.resize(cells_.size());
  models_.resize(cells_.size());
  std::size_t known = 0;
  const int first_tile = wall.tile(row, 0);
  int column = wall.column_of(perceived.tile);
  for (int turn = 0; turn < columns; ++turn) {
    const int tile = first_tile + column;
    if (++column == columns) column = 0;
    turns_[known] = turn;
    models_[known] = &model[tile];
    if (model.trusted(tile)) ++known;
  }
  turns_.resize(known);
  models_.resize(known);
  if (turns_.empty()) return;
  // Viewpoints more than 90 and less than 270 degrees away are nearer to the reflection.
  const auto first_behind = std::upper_bound(turns_.begin(), turns_.end(), columns / 4) - turns_.begin();
  const auto last_behind = std::lower_bound(turns_.begin(), turns_.end(), (3 * columns + 3) / 4) - turns_.begin();
  distances_.resize(turns_.size());
  const auto compare_part = [&](std::ptrdiff_t begin, std::ptrdiff_t end, const ComparedHistogram& histogram) {
    const auto first = static_cast<std::size_t>(begin);
    const auto count = static_cast<std::size_t>(end - begin);
    distances(comparison.measure, histogram, std::span(models_).subspan(first, count),
              std::span(distances_).subspan(first, count));
  };
  compare_part(0, first_behind, perceived.histogram);
  compare_part(first_behind, last_behind, perceived.reflected_histogram);
  compare_part(last_behind, std::ssize(turns_), perceived.histogram);
  const std::size_t begin = tile_distances_.size();
  tile_distances_.resize(begin + cells_.size(), kUnknown);
  compared_tiles_.push_back(perceived.tile);
  for (std::size_t i = 0; i < turns_.size(); ++i) {
    const auto turn = static_cast<std::size_t>(turns_[i]);
    cells_[turn].distance += std::min(comparison.cap, distances_[i]);
    ++cells_[turn].compared;
    tile_distances_[begin + turn] = distances_[i];
  }
}

const ViewpointScore& ViewpointScores::at(int turn) const {
  if (turn >= 0 && turn < columns()) return cells_[static_cast<std::size_t>(turn)];
  const int wrapped = turn % columns();
  return cells_[static_cast<std::size_t>(wrapped < 0 ? wrapped + columns() : wrapped)];
}

double ViewpointScores::distance(double turn) const {
  const double below = std::floor(turn);
  const double fraction = turn - below;
  const int cell = static_cast<int>(below);
  return (1.0 - fraction) * at(cell).distance + fraction * at(cell + 1).distance;
}

}  // namespace reorient
