// SPDX-License-Identifier: MIT
#include "perception/room/evidence/pose_lights.h"

#include <algorithm>
#include <cmath>

#include "geometry/bytes.h"
#include "geometry/pinned_math.h"

namespace reorient {

void PoseLights::restart(int tiles) {
  tiles_.assign(static_cast<std::size_t>(tiles), SeenLight{});
  until_next_ = 0.0;
}

void PoseLights::observe(std::span<const TileLight> frame, const Light& mean, const BackgroundModel& model,
                         const Wall& wall, double elapsed, const PoseLightParameters& parameters) {
  for (SeenLight& tile : tiles_) tile.unseen += elapsed;
  for (const TileLight& seen : frame) {
    if (seen.counts()) tiles_[static_cast<std::size_t>(seen.tile)] = {seen.sums.mean(), 0.0, true};
  }
  until_next_ -= elapsed;
  if (until_next_ > 0.0) return;
  until_next_ = parameters.period;
  if_believed_ = estimate(mean, model, wall, false, parameters);
  if_reflected_ = estimate(mean, model, wall, true, parameters);
}

/// The mean of the tiles' lights, each limited to the bounds around the mean light, and of the mean light itself.
Light PoseLights::estimate(const Light& mean, const BackgroundModel& model, const Wall& wall, bool reflected,
                           const PoseLightParameters& parameters) const {
  constexpr double kDarkest = 0.02;  // fraction of the room's luma, lower limit for a tile
  const auto within = [](double value, double most) { return std::clamp(value, -most, most); };
  double luma = 0.0, cb = 0.0, cr = 0.0;
  int count = 0;
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    const SeenLight& seen = tiles_[static_cast<std::size_t>(tile)];
    if (!seen.known || seen.unseen > parameters.memory) continue;
    const TileModel& learned = model[reflected ? wall.reflected(tile) : tile];
    if (learned.light_visits == 0) continue;
    const RelativeLight& known = learned.light;
    const double ratio = seen.light.luma / (mean.luma * std::max(known.luma, kDarkest));
    luma += within(ratio > 0.0 ? pinned::log(ratio) : 0.0, parameters.most_luma);
    cb += within(seen.light.cb - known.cb - mean.cb, parameters.most_chroma);
    cr += within(seen.light.cr - known.cr - mean.cr, parameters.most_chroma);
    ++count;
  }
  const double weight = count + parameters.caution;
  if (weight <= 0.0) return mean;
  return {mean.luma * pinned::exp(luma / weight), mean.cb + cb / weight, mean.cr + cr / weight};
}

void PoseLights::reflect(const Wall& wall) {
  rotate_by_180_degrees(wall);
  std::swap(if_believed_, if_reflected_);
}

/// Checks values after reading.
void PoseLights::check(std::size_t tiles) const {
  check_bytes(tiles_.size() == tiles, "pose light: expected one entry for each tile of the wall");
  check_bytes(is_sound(if_believed_) && is_sound(if_reflected_) && std::isfinite(until_next_),
              "pose light: a light is invalid");
  for (const SeenLight& tile : tiles_) reorient::check(tile);
}

}  // namespace reorient
