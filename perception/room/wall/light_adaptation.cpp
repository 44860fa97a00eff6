// SPDX-License-Identifier: MIT
#include "perception/room/wall/light_adaptation.h"

#include <algorithm>
#include <cmath>

#include "geometry/bytes.h"

namespace reorient {
namespace {

/// Weighted mean: `fraction` of `b`, and the rest of `a`.
Light mixed(const Light& a, const Light& b, double fraction) {
  return {a.luma + fraction * (b.luma - a.luma), a.cb + fraction * (b.cb - a.cb), a.cr + fraction * (b.cr - a.cr)};
}

}  // namespace

Light LightSums::mean() const {
  if (pixels == 0) return {};
  return {luma / pixels, cb / pixels, cr / pixels};
}

LightSums sum_light(const ImageView& image, int row, int left, int right, const LightParameters& parameters) {
  LightSums sums;
  const std::uint8_t* pixels = image.row(row);
  const double darkest = parameters.darkest;
  const double brightest = parameters.brightest;
  int luma = 0;
  int cb = 0;
  int cr = 0;
  for (int x = left & ~1; x < right; x += 8) {
    const std::uint8_t* pair = pixels + 2 * x;
    if (pair[0] <= darkest || pair[0] >= brightest) continue;
    luma += pair[0];
    cb += pair[1];
    cr += pair[3];
    ++sums.pixels;
  }
  sums.luma = luma;
  sums.cb = cb;
  sums.cr = cr;
  return sums;
}

void check(const SeenLight& tile) {
  check_bytes(is_sound(tile.light) && std::isfinite(tile.unseen), "light: a tile has an invalid value");
}

/// Checks values after reading.
void LightAdaptation::check(std::size_t tiles) const {
  check_bytes(tiles_.size() == tiles, "light adaptation: expected one entry for each tile of the wall");
  check_bytes(is_sound(light_) && std::isfinite(unseen_), "light adaptation: the light of the room is invalid");
  for (const SeenLight& tile : tiles_) reorient::check(tile);
}

void LightAdaptation::forget_tiles() { std::fill(tiles_.begin(), tiles_.end(), SeenLight{}); }

void LightAdaptation::restart(int tiles) {
  tiles_.resize(static_cast<std::size_t>(tiles));
  forget_tiles();
  light_ = {};
  unseen_ = 0.0;
}

void LightAdaptation::observe(std::span<const TileLight> frame, double elapsed, const LightParameters& parameters) {
  constexpr int kFewest = 10;  // pixels of a tile; fewer do not give a reliable mean
  unseen_ += elapsed;
  if (unseen_ > parameters.fresh_after) forget_tiles();
  for (SeenLight& tile : tiles_) {
    tile.unseen += elapsed;
    if (tile.unseen > parameters.memory) tile.known = false;
  }
  for (const TileLight& seen : frame) {
    if (seen.sums.pixels < kFewest) continue;
    SeenLight& tile = tiles_[static_cast<std::size_t>(seen.tile)];
    const double fraction = tile.known && elapsed > 0.0 ? elapsed / (parameters.time_constant + elapsed) : 1.0;
    tile.light = mixed(tile.light, seen.sums.mean(), fraction);
    tile.known = true;
    tile.unseen = 0.0;
    unseen_ = 0.0;
  }
  Light sum{0.0, 0.0, 0.0};
  int known = 0;
  for (const SeenLight& tile : tiles_) {
    if (!tile.known) continue;
    sum = {sum.luma + tile.light.luma, sum.cb + tile.light.cb, sum.cr + tile.light.cr};
    ++known;
  }
  if (known > 0) light_ = {sum.luma / known, sum.cb / known, sum.cr / known};
}

}  // namespace reorient
