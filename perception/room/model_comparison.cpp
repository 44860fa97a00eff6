// SPDX-License-Identifier: MIT
#include "perception/room/model_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "perception/room/color/histogram_distance.h"

namespace reorient {
namespace {

bool is_known(const TileModel& tile) { return tile.is_trained_for(BackgroundParameters().trusted_after); }

double difference(const TileModel& a, const TileModel& b) { return distance(Distance::hellinger, a.mean, b.mean); }

int sum_of(int a, int b) {
  const std::int64_t sum = std::int64_t{a} + b;
  return static_cast<int>(std::min<std::int64_t>(sum, std::numeric_limits<int>::max()));
}

/// Weights of two models in their merged model.
struct Weights {
  Weights(int first, int second)
      : a(static_cast<double>(first) / (static_cast<double>(first) + second)),
        b(static_cast<double>(second) / (static_cast<double>(first) + second)) {}
  double of(double first, double second) const { return a * first + b * second; }

  double a;
  double b;
};

void merge_colors(TileModel& tile, const TileModel& a, const TileModel& b) {
  const Weights weights(a.visits, b.visits);
  for (std::size_t bin = 0; bin < tile.mean.size(); ++bin) {
    const double mean = weights.of(a.mean[bin], b.mean[bin]);
    // Variance within each model, and the difference of their means.
    const double apart = a.mean[bin] - static_cast<double>(b.mean[bin]);
    const double variance = weights.of(a.variance[bin], b.variance[bin]) + weights.a * weights.b * apart * apart;
    tile.mean[bin] = static_cast<float>(std::clamp(mean, 0.0, 1.0));
    tile.variance[bin] = static_cast<float>(std::clamp(variance, 0.0, 1.0));
  }
}

void merge_light(TileModel& tile, const TileModel& a, const TileModel& b) {
  const Weights weights(a.light_visits, b.light_visits);
  tile.light = {weights.of(a.light.luma, b.light.luma), weights.of(a.light.cb, b.light.cb),
                weights.of(a.light.cr, b.light.cr)};
}

TileModel merged(const TileModel& a, const TileModel& b) {
  TileModel tile;
  tile.visits = sum_of(a.visits, b.visits);
  tile.trained = std::min(a.trained + b.trained, kLongestTraining);
  tile.light_visits = sum_of(a.light_visits, b.light_visits);
  if (tile.visits > 0) merge_colors(tile, a, b);
  if (tile.light_visits > 0) merge_light(tile, a, b);
  return tile;
}

/// Mean difference between tiles of one row that are at least a sixteenth of the wall apart.
std::optional<double> difference_of_parts(const SavedModel& model, const Wall& wall) {
  const int columns = wall.columns(), least = std::max(1, columns / 16);
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < wall.rows(); ++row) {
    for (int one = 0; one < columns; ++one) {
      const TileModel& a = model.model[wall.tile(row, one)];
      if (!is_known(a)) continue;
      for (int apart = least; apart <= columns - least; ++apart) {
        const TileModel& b = model.model[wall.tile(row, (one + apart) % columns)];
        if (!is_known(b)) continue;
        sum += difference(a, b);
        ++count;
      }
    }
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

bool ModelComparison::is_of_one_room() const {
  constexpr double kSameRoom = 0.78;  // of the spread: between the largest of one room and the smallest of two
  if (!mean || !spread) return false;
  return std::min(*mean, sides ? sides->turned : *mean) < kSameRoom * *spread;
}

ModelComparison compare(const SavedModel& first, const SavedModel& second) {
  const Wall wall(first.basis.wall);
  ModelComparison result;
  double sum = 0.0;
  ModelComparison::Sides sides;
  int on_both_sides = 0;
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    const TileModel &a = first.model[tile], &b = second.model[tile], &turned = second.model[wall.reflected(tile)];
    if (is_known(a) && !is_known(b)) ++result.only_first;
    if (is_known(b) && !is_known(a)) ++result.only_second;
    if (!is_known(a) || !is_known(b)) continue;
    const double as_it_is = difference(a, b);
    result.tiles.push_back({tile, as_it_is});
    sum += as_it_is;
    if (!is_known(turned)) continue;
    ++on_both_sides;
    sides.as_it_is += as_it_is;
    sides.turned += difference(a, turned);
  }
  std::stable_sort(result.tiles.begin(), result.tiles.end(),
                   [](const TileDifference& a, const TileDifference& b) { return a.distance > b.distance; });
  if (!result.tiles.empty()) result.mean = sum / static_cast<double>(result.tiles.size());
  const std::optional<double> in_first = difference_of_parts(first, wall),
                              in_second = difference_of_parts(second, wall);
  if (in_first && in_second) result.spread = std::sqrt(*in_first * *in_second);
  if (on_both_sides > 0) result.sides = {sides.as_it_is / on_both_sides, sides.turned / on_both_sides};
  return result;
}

SavedModel merged(const SavedModel& first, const SavedModel& second) {
  SavedModel both{first.basis, std::min(first.learned + second.learned, kLongestTraining), {}};
  std::vector<TileModel> tiles;
  tiles.reserve(first.model.tiles().size());
  for (int tile = 0; tile < Wall(first.basis.wall).tiles(); ++tile)
    tiles.push_back(merged(first.model[tile], second.model[tile]));
  both.model = BackgroundModel(std::move(tiles));
  return both;
}

}  // namespace reorient
