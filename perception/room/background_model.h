// SPDX-License-Identifier: MIT
// The background model (the paper's Section 3.3): for each tile of the wall a histogram with its variance.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/const_or.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/wall/wall.h"

namespace reorient {

struct BackgroundParameters {
  double time_constant = 30.0;
  bool true_mean_start = true;
  double prior_deviation = 0.1;
  double trusted_after = 0.3;
};
template <typename Visit>
void describe(BackgroundParameters& p, Visit&& visit) {
  visit("time_constant", p.time_constant, 0.1, 3600.0, "s",
        "time constant of a tile's mean and variance while it is in view: N of Eq. (1) and (2), times the time of a "
        "frame");
  visit("true_mean_start", p.true_mean_start,
        "whether N of Eq. (1) and (2) grows with the visits of a tile until it reaches time_constant");
  visit("prior_deviation", p.prior_deviation, 0.0, 1.0, "", "standard deviation of each bin before training");
  visit("trusted_after", p.trusted_after, 0.0, 60.0, "s", "training time after which a tile is used for comparisons");
}

/// One bin's moving average and variance.
struct MovingAverage {
  double mean = 0.0;
  double variance = 0.0;
};

/// Eq. (1) and (2) of the paper: the average after a measurement with weight 1 against N.
MovingAverage updated(const MovingAverage& last, double n, double measured);

/// How one measurement updates a tile.
struct TrainingStep {
  double step = 0.0;            ///< s, time that this measurement represents
  double n = 100.0;             ///< N
  bool true_mean_start = true;  ///< N grows with the visits up to n; otherwise it is n from the second visit on
  double prior_variance = 0.0;  ///< of each bin at the first visit, at which the mean is copied
};

struct TileModel {
  ColorHistogram mean{};
  ColorHistogram variance{};
  int visits = 0;        ///< 0: never seen
  double trained = 0.0;  ///< s
  RelativeLight light;   ///< mean
  int light_visits = 0;  ///< visits with enough pixels that are neither too dark nor too bright

  /// Whether the tile was seen and trained for at least this many seconds.
  bool is_trained_for(double seconds) const { return visits > 0 && trained >= seconds; }
};
template <typename Visit, ConstOr<TileModel> T>
void fields(Visit&& visit, T& tile) {
  visit(tile.mean, tile.variance, tile.visits, tile.trained, tile.light, tile.light_visits);
}

/// Limit of a valid training time: thirty years, s.
inline constexpr double kLongestTraining = 1e9;

class BackgroundModel {
 public:
  BackgroundModel() = default;
  explicit BackgroundModel(std::vector<TileModel> tiles) : tiles_(std::move(tiles)) {}

  /// All tiles unseen.
  void forget(int tiles);
  void train(int tile, const ColorHistogram& measured, const TrainingStep& how);
  void train_light(int tile, const RelativeLight& measured, const TrainingStep& how);
  /// Rotates the field's axes by 180 degrees: exchanges each tile with its reflection.
  void rotate_by_180_degrees(const Wall& wall) { wall.rotate_by_180_degrees(std::span(tiles_)); }

  std::span<const TileModel> tiles() const { return tiles_; }
  /// Number of tiles that were ever seen.
  int known_tiles() const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t tiles = self.tiles_.size();
    archive(self.tiles_);
    if constexpr (Archive::kReads) self.check(tiles);
  }
  const TileModel& operator[](int tile) const { return tiles_[static_cast<std::size_t>(tile)]; }

 private:
  void check(std::size_t tiles) const;

  std::vector<TileModel> tiles_;
};

}  // namespace reorient
