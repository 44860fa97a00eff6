// SPDX-License-Identifier: MIT
#include "workbench/rating/synthetic_looks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "perception/room/color/histogram_distance.h"

namespace reorient {
namespace {

/// The known tiles of one row.
std::vector<int> known_tiles_of(int row, const BackgroundModel& model, const Wall& wall, double trusted_after) {
  std::vector<int> known;
  for (int column = 0; column < wall.columns(); ++column) {
    const int tile = wall.tile(row, column);
    if (model[tile].is_trained_for(trusted_after)) known.push_back(tile);
  }
  return known;
}

ColorHistogram look_at(const TileModel& tile, const std::array<double, kColorBins>& normals, double scale) {
  ColorHistogram look{};
  double sum = 0.0;
  for (std::size_t bin = 0; bin < look.size(); ++bin) {
    const double deviation = std::sqrt(std::max(static_cast<double>(tile.variance[bin]), 0.0));
    const double share = std::max(static_cast<double>(tile.mean[bin]) + scale * deviation * normals[bin], 0.0);
    look[bin] = static_cast<float>(share);
    sum += share;
  }
  if (sum <= 0.0) return tile.mean;
  for (float& share : look) share = static_cast<float>(static_cast<double>(share) / sum);
  return look;
}

double mean_misfit(const BackgroundModel& model, const Wall& wall, double trusted_after, double scale) {
  constexpr std::uint64_t kDraws = 4;
  double sum = 0.0;
  int count = 0;
  for (std::uint64_t draw = 0; draw < kDraws; ++draw) {
    const Looks looks = draw_looks(model, wall, trusted_after, scale, Random(1, draw));
    for (int tile = 0; tile < wall.tiles(); ++tile) {
      if (!model[tile].is_trained_for(trusted_after)) continue;
      sum += distance(Distance::hellinger, looks[static_cast<std::size_t>(tile)], model[tile].mean);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace

Looks draw_looks(const BackgroundModel& model, const Wall& wall, double trusted_after, double scale, Random random) {
  Looks looks(static_cast<std::size_t>(wall.tiles()));
  for (int row = 0; row < wall.rows(); ++row) {
    const std::vector<int> known = known_tiles_of(row, model, wall, trusted_after);
    for (int column = 0; column < wall.columns(); ++column) {
      std::array<double, kColorBins> normals{};
      for (double& normal : normals) normal = random.normal();
      const double other = random.uniform();
      const int tile = wall.tile(row, column);
      int shown = tile;
      if (!model[tile].is_trained_for(trusted_after) && !known.empty())
        shown = known[static_cast<std::size_t>(other * static_cast<double>(known.size()))];
      looks[static_cast<std::size_t>(tile)] = look_at(model[shown], normals, scale);
    }
  }
  return looks;
}

double scale_for_misfit(const BackgroundModel& model, const Wall& wall, double trusted_after, double misfit) {
  constexpr double kMost = 32.0;
  constexpr int kHalvings = 20;
  double low = 0.0, high = kMost;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (mean_misfit(model, wall, trusted_after, middle) < misfit ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace reorient
