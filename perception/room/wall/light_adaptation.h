// SPDX-License-Identifier: MIT
// The room's light as the camera shows it. The thresholds follow exposure and white balance, so that their changes do
// not invalidate the model.
#pragma once

#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "geometry/image.h"
#include "perception/room/color/color_histogram.h"
#include "perception/room/wall/wall.h"

namespace reorient {

struct LightParameters {
  bool enabled = true;
  double time_constant = 1.0;
  double memory = 20.0;
  double darkest = 15.0;
  double brightest = 245.0;
  double fresh_after = 2.0;
};
template <typename Visit>
void describe(LightParameters& p, Visit&& visit) {
  visit("enabled", p.enabled, "whether the color thresholds follow the light of the room");
  visit("time_constant", p.time_constant, 0.0, 60.0, "s",
        "time over which the light of each tile is averaged while it is in view");
  visit("memory", p.memory, 1.0, 600.0, "s",
        "time for which a tile that is out of view counts in the light of the room");
  visit("darkest", p.darkest, 0.0, 254.0, "", "largest luma of pixels that are too dark for the means");
  visit("brightest", p.brightest, 1.0, 255.0, "", "smallest luma of pixels that are too bright for the means");
  visit("fresh_after", p.fresh_after, 0.0, 60.0, "s",
        "time without any wall in view after which the light adaptation restarts");
}

/// Sums over some pixels of the wall.
struct LightSums {
  double luma = 0.0;
  double cb = 0.0;
  double cr = 0.0;
  int pixels = 0;

  LightSums& operator+=(const LightSums& other) {
    luma += other.luma;
    cb += other.cb;
    cr += other.cr;
    pixels += other.pixels;
    return *this;
  }
  Light mean() const;  ///< neutral without pixels
};

/// Every eighth pixel of one row, columns left...right - 1, that is neither too dark nor too bright.
LightSums sum_light(const ImageView& image, int row, int left, int right, const LightParameters& parameters);

/// The light on one tile in one frame.
struct TileLight {
  int tile = 0;
  LightSums sums;

  /// Whether there are enough pixels to compare its light with the tile's model.
  bool counts() const { return sums.pixels >= 5; }
};

/// The stored light of one tile.
struct SeenLight {
  Light light;
  double unseen = 0.0;  ///< s since it was last in view
  bool known = false;
};
template <typename Visit, ConstOr<SeenLight> T>
void fields(Visit&& visit, T& tile) {
  visit(tile.light, tile.unseen, tile.known);
}
/// Checks a value that was read: throws BadBytes if it is impossible.
void check(const SeenLight& tile);

/// The mean over the recently seen parts of the wall, with the same weight for each tile. So it depends neither on the
/// camera's current direction nor on the duration of a view.
class LightAdaptation {
 public:
  /// Processes one frame. `elapsed`: s since the frame before, of any length.
  void observe(std::span<const TileLight> frame, double elapsed, const LightParameters& parameters);
  /// Resets the light for a wall with this many tiles.
  void restart(int tiles);
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees(const Wall& wall) { wall.rotate_by_180_degrees(std::span(tiles_)); }
  /// Neutral until something was seen.
  const Light& light() const { return light_; }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t tiles = self.tiles_.size();
    archive(self.light_, self.tiles_, self.unseen_);
    if constexpr (Archive::kReads) self.check(tiles);
  }

 private:
  void check(std::size_t tiles) const;

  void forget_tiles();

  Light light_;
  std::vector<SeenLight> tiles_;
  double unseen_ = 0.0;  // s since any wall was in view
};

}  // namespace reorient
