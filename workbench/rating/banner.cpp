// SPDX-License-Identifier: MIT
#include "workbench/rating/banner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/angle.h"

namespace reorient {
namespace {

constexpr int kFirstColor = 2;  // bin

double overlap(double begin, double end, double other_begin, double other_end) {
  return std::max(0.0, std::min(end, other_end) - std::max(begin, other_begin));
}

/// Fraction of a tile's area.
double covered_part(int tile, const Wall& wall, const Banner& banner) {
  const double half = 0.5 * banner.width / wall.radius();
  const double side = 0.5 * wall.column_width();
  const double middle = normalize_angle((wall.column_of(tile) + 0.5) * wall.column_width() - banner.azimuth);
  const double across = overlap(middle - side, middle + side, -half, half) / wall.column_width();
  const double bottom = wall.bottom() + wall.row_of(tile) * wall.row_height();
  const double upwards =
      overlap(bottom, bottom + wall.row_height(), banner.foot, banner.foot + banner.height) / wall.row_height();
  return std::clamp(across * upwards, 0.0, 1.0);
}

}  // namespace

int rarest_color(const BackgroundModel& model) {
  std::array<double, kColorBins> shares{};
  for (const TileModel& tile : model.tiles()) {
    for (std::size_t bin = 0; bin < shares.size(); ++bin) shares[bin] += tile.visits > 0 ? tile.mean[bin] : 0.0f;
  }
  return static_cast<int>(std::min_element(shares.begin() + kFirstColor, shares.end()) - shares.begin());
}

const char* color_in_words(int bin) {
  constexpr const char* kNames[kColorBins] = {
      "black", "white", "dark green", "dark blue",   "dark red",   "dark violet", "green",
      "blue",  "red",   "violet",     "light green", "light blue", "light red",   "light violet",
  };
  return kNames[static_cast<std::size_t>(std::clamp(bin, 0, kColorBins - 1))];
}

SavedModel with_banner(const SavedModel& model, const Banner& banner) {
  const Wall wall(model.basis.wall);
  std::vector<TileModel> tiles(model.model.tiles().begin(), model.model.tiles().end());
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double part = covered_part(static_cast<int>(i), wall, banner);
    if (part <= 0.0 || tiles[i].visits == 0) continue;
    const auto left = static_cast<float>(1.0 - part);
    for (float& share : tiles[i].mean) share *= left;
    for (float& variance : tiles[i].variance) variance *= left * left;
    tiles[i].mean[static_cast<std::size_t>(banner.color)] += static_cast<float>(part);
  }
  SavedModel changed = model;
  changed.model = BackgroundModel(std::move(tiles));
  return changed;
}

}  // namespace reorient
