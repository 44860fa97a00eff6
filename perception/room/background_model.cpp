#include "perception/room/background_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bytes.h"

namespace reorient {

MovingAverage updated(const MovingAverage& last, double n, double measured) {
  const double difference = last.mean - measured;
  MovingAverage result;
  result.mean = (n * last.mean + measured) / (n + 1.0);
  result.variance = (n * last.variance + n / (n + 1.0) * difference * difference) / (n + 1.0);
  return result;
}

void BackgroundModel::forget(int tiles) { tiles_.assign(static_cast<std::size_t>(tiles), TileModel{}); }

/// After reading.
void BackgroundModel::check(std::size_t tiles) const {
  check_bytes(tiles_.size() == tiles, "the model of a wall with another number of tiles");
  const auto is_share = [](float value) { return value >= 0.0f && value <= 1.0f; };
  for (const TileModel& tile : tiles_) {
    check_bytes(std::all_of(tile.mean.begin(), tile.mean.end(), is_share) &&
                    std::all_of(tile.variance.begin(), tile.variance.end(), is_share) && tile.visits >= 0 &&
                    std::isfinite(tile.trained) && std::isfinite(tile.light.luma) && std::isfinite(tile.light.cb) &&
                    std::isfinite(tile.light.cr) && tile.light_visits >= 0,
                "a tile of the model is none");
  }
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
  model.trained += how.step;
}

void BackgroundModel::train_light(int tile, const RelativeLight& measured, const TrainingStep& how) {
  TileModel& model = tiles_[static_cast<std::size_t>(tile)];
  const double share = 1.0 / (std::min<double>(model.light_visits, how.n) + 1.0);
  model.light.luma += share * (measured.luma - model.light.luma);
  model.light.cb += share * (measured.cb - model.light.cb);
  model.light.cr += share * (measured.cr - model.light.cr);
  if (model.light_visits < std::numeric_limits<int>::max()) ++model.light_visits;
}

}  // namespace reorient
