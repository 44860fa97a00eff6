// SPDX-License-Identifier: MIT
#include "perception/room/background_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/bytes.h"

namespace reorient {
namespace {

/// Whether the tile could result from training: light in byte range up to 255, and histogram fractions with the sum 1.
bool could_be_learned(const TileModel& tile) {
  constexpr float kRounding = 1e-3f;
  constexpr double kMost = 255.0;
  const auto is_share = [](float value) { return value >= 0.0f && value <= 1.0f; };
  const float sum = std::accumulate(tile.mean.begin(), tile.mean.end(), 0.0f);
  return std::all_of(tile.mean.begin(), tile.mean.end(), is_share) &&
         std::all_of(tile.variance.begin(), tile.variance.end(), is_share) && tile.visits >= 0 &&
         (tile.visits == 0 || std::abs(sum - 1.0f) <= kRounding) && tile.trained >= 0.0 &&
         tile.trained <= kLongestTraining && tile.light.luma >= 0.0 && tile.light.luma <= kMost &&
         std::abs(tile.light.cb) <= kMost && std::abs(tile.light.cr) <= kMost && tile.light_visits >= 0;
}

}  // namespace

MovingAverage updated(const MovingAverage& last, double n, double measured) {
  const double difference = last.mean - measured;
  MovingAverage result;
  result.mean = (n * last.mean + measured) / (n + 1.0);
  result.variance = (n * last.variance + n / (n + 1.0) * difference * difference) / (n + 1.0);
  return result;
}

void BackgroundModel::forget(int tiles) { tiles_.assign(static_cast<std::size_t>(tiles), TileModel{}); }

int BackgroundModel::known_tiles() const {
  return static_cast<int>(
      std::count_if(tiles_.begin(), tiles_.end(), [](const TileModel& tile) { return tile.visits > 0; }));
}

/// Checks values after reading.
void BackgroundModel::check(std::size_t tiles) const {
  check_bytes(tiles_.size() == tiles, "background model: expected one entry for each tile of the wall");
  check_bytes(std::all_of(tiles_.begin(), tiles_.end(), could_be_learned),
              "background model: a tile has an invalid value");
}

void BackgroundModel::train(int tile, const ColorHistogram& measured, const TrainingStep& how) {
  TileModel& model = tiles_[static_cast<std::size_t>(tile)];
  if (model.visits == 0) {
    model.mean = measured;
    model.variance.fill(static_cast<float>(how.prior_variance));
  } else {
    const double n = how.true_mean_start ? std::min<double>(model.visits, how.n) : how.n;
    for (std::size_t bin = 0; bin < measured.size(); ++bin) {
      const MovingAverage bin_now =
          updated({model.mean[bin], model.variance[bin]}, n, static_cast<double>(measured[bin]));
      model.mean[bin] = static_cast<float>(bin_now.mean);
      model.variance[bin] = static_cast<float>(bin_now.variance);
    }
  }
  if (model.visits < std::numeric_limits<int>::max()) ++model.visits;
  model.trained = std::min(model.trained + how.step, kLongestTraining);
}

void BackgroundModel::train_light(int tile, const RelativeLight& measured, const TrainingStep& how) {
  TileModel& model = tiles_[static_cast<std::size_t>(tile)];
  const double fraction = 1.0 / (std::min<double>(model.light_visits, how.n) + 1.0);
  model.light.luma += fraction * (measured.luma - model.light.luma);
  model.light.cb += fraction * (measured.cb - model.light.cb);
  model.light.cr += fraction * (measured.cr - model.light.cr);
  if (model.light_visits < std::numeric_limits<int>::max()) ++model.light_visits;
}

}  // namespace reorient
