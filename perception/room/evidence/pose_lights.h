// SPDX-License-Identifier: MIT
// The light of the room that the believed pose implies, and the light that its reflection implies. Each pose is
// evaluated in the light that fits it best, so that a change of the light is no evidence for either.
#pragma once

#include <span>
#include <vector>

#include "perception/room/background_model.h"
#include "perception/room/wall/light_adaptation.h"
#include "perception/room/wall/wall.h"

namespace reorient {

struct PoseLightParameters {
  bool enabled = true;
  double memory = 8.0;
  double caution = 8.0;
  double most_luma = 0.7;
  double most_chroma = 12.0;
  double period = 0.25;
};
template <typename Visit>
void describe(PoseLightParameters& p, Visit&& visit) {
  visit("enabled", p.enabled,
        "whether each pose is evaluated in the light that it implies; otherwise both are evaluated in the mean light");
  visit("memory", p.memory, 0.5, 600.0, "s", "time for which a tile that is out of view still counts");
  visit("caution", p.caution, 0.0, 1000.0, "", "weight of the mean light, as a number of tiles");
  visit("most_luma", p.most_luma, 0.0, 3.0, "",
        "largest deviation of a light from the mean light, in the natural logarithm of luma");
  visit("most_chroma", p.most_chroma, 0.0, 64.0, "",
        "largest deviation of a light from the mean light in Cb and in Cr");
  visit("period", p.period, 0.0, 10.0, "s",
        "time between two estimates of the two lights, since the light changes slowly");
}

class PoseLights {
 public:
  /// Forgets all observations of a wall with this many tiles. Both lights are the mean light until the next
  /// observation.
  void restart(int tiles);
  /// Processes one frame: the light on the tiles at their believed positions. `mean`: mean light of the recent
  /// observations.
  void observe(std::span<const TileLight> frame, const Light& mean, const BackgroundModel& model, const Wall& wall,
               double elapsed, const PoseLightParameters& parameters);
  /// Exchanges the two lights after a flip.
  void reflect(const Wall& wall);
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees(const Wall& wall) { wall.rotate_by_180_degrees(std::span(tiles_)); }

  const Light& if_believed() const { return if_believed_; }
  const Light& if_reflected() const { return if_reflected_; }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t tiles = self.tiles_.size();
    archive(self.tiles_, self.if_believed_, self.if_reflected_, self.until_next_);
    if constexpr (Archive::kReads) self.check(tiles);
  }

 private:
  void check(std::size_t tiles) const;
  Light estimate(const Light& mean, const BackgroundModel& model, const Wall& wall, bool reflected,
                 const PoseLightParameters& parameters) const;

  std::vector<SeenLight> tiles_;
  Light if_believed_, if_reflected_;
  double until_next_ = 0.0;  // s
};

}  // namespace reorient
