// SPDX-License-Identifier: MIT
// How strongly the room speaks for the reflection of the believed pose against that pose itself, as log-odds.
#pragma once

#include <span>
#include <vector>

#include "geometry/const_or.h"
#include "perception/room/compared_model.h"
#include "perception/room/view/viewpoint_scores.h"
#include "perception/room/wall/wall.h"

namespace reorient {

struct EvidenceParameters {
  double gain = 5.0;
  double cap = 1.0;
  double distinct = 0.1;
  double half_trained = 1.6;
  double unknown = 0.3;
  double right = 0.3;
  double settle = 1.0;
  double look = 0.05;
  double leak = 5.0;
  double tolerance = 0.4;
  bool use_separability = true;
};
template <typename Visit>
void describe(EvidenceParameters& p, Visit&& visit) {
  visit("gain", p.gain, 0.0, 100.0, "",
        "log-odds of a tile per unit of histogram distance by which one pose explains it better");
  visit("cap", p.cap, 0.01, 2.0, "",
        "largest difference in histogram distance by which one pose can explain a tile better");
  visit("distinct", p.distinct, 0.0, 1.0, "",
        "histogram distance between a tile of the model and its reflection at which the tile has half weight");
  visit("half_trained", p.half_trained, 0.0, 60.0, "s",
        "training time at which a tile of the model, or its reflection, has half weight");
  visit("unknown", p.unknown, 0.0, 1.0, "",
        "weight of a tile that is known for only one of the two poses, for which only that one distance is used");
  visit("right", p.right, 0.0, 1.0, "",
        "expected histogram distance between a tile of the model and its view from the correct pose");
  visit("settle", p.settle, 0.01, 60.0, "s", "time over which the evidence of a tile is averaged while it is in view");
  visit("look", p.look, 0.0, 10.0, "s", "time in view after which a tile has half of its weight");
  visit("leak", p.leak, 0.1, 1000.0, "s",
        "time constant with which a tile's time in view fades while it is out of view");
  visit("tolerance", p.tolerance, 0.0, 1.5, "rad",
        "largest angle between the view and the tiles where it was learned (parallax)");
  visit("use_separability", p.use_separability,
        "whether the evidence is multiplied by max(2 p - 1, 0), where p is confidence.separability");
}

/// EvidenceParameters::tolerance, in columns.
int tolerated_columns(const EvidenceParameters& parameters, const Wall& wall);

/// Each tile has one say, however long it is looked at: what is wrong with it, because the light or the wall has
/// changed, stays wrong from frame to frame. So a look at another tile is new evidence, and more of the same is not.
///
/// The say of a tile is gain * w * (how much nearer the reflected tile of the model is than the tile itself), and the
/// log-odds are the sum over the tiles. With d the distance between those two tiles of the model and t1, t2 the times
/// for which they were trained,
///
///     w = d^2 / (d^2 + distinct^2) * t1 / (t1 + half_trained) * t2 / (t2 + half_trained)
///
/// since a tile that was seen for a moment only may look otherwise the next time. A tile of which only one of the two
/// is known says, with the weight `unknown`, how well that one fits.
class Evidence {
 public:
  /// Nothing was seen yet of a wall with this many tiles.
  void restart(int tiles);
  /// One frame of `step` seconds.
  void observe(std::span<const ComparedPlace> places, const ComparedModel& model, double step,
               const EvidenceParameters& parameters);
  /// The belief went over to its reflection: the tiles trade places, and what spoke for the one speaks for the other.
  void reflect(const Wall& wall);
  /// The wall's tiles are counted from the other end of the field.
  void turn_half(const Wall& wall) { wall.turn_half(std::span(tiles_)); }

  /// 0: nothing is known; log(99): 99 in 100 that the reflection is right.
  double log_odds() const { return log_odds_; }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t tiles = self.tiles_.size();
    archive(self.tiles_, self.log_odds_);
    if constexpr (Archive::kReads) self.check(tiles);
  }

 private:
  struct SeenTile {
    double say = 0.0;   // the mean, per gain; positive: for the reflection
    double time = 0.0;  // s in view, at most `settle`; fading
  };
  template <typename Visit, ConstOr<SeenTile> T>
  friend void fields(Visit&& visit, T& tile) {
    visit(tile.say, tile.time);
  }

  void check(std::size_t tiles) const;

  std::vector<SeenTile> tiles_;
  double log_odds_ = 0.0;
};

}  // namespace reorient
