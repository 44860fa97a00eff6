// SPDX-License-Identifier: MIT
// Evidence of the room for the mirrored pose against that pose, as log-odds.
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

/// Each tile counts once, independent of its time in view. An error of a tile, caused by a change of the light or the
/// wall, remains from frame to frame. So a view of another tile is new evidence, and a longer view of the same tile is
/// not.
///
/// A tile contributes gain * w * (distance to the model's tile - distance to the model's reflected tile). The log-odds
/// are the sum over the tiles. With d the distance between these two tiles of the model and t1, t2 their training
/// times,
///
///     w = d^2 / (d^2 + distinct^2) * t1 / (t1 + half_trained) * t2 / (t2 + half_trained)
///
/// since a tile that was seen for only a moment may look different the next time. For a tile of which only one of the
/// two is known, the fit of that one counts with the weight `unknown`.
class Evidence {
 public:
  /// Starts without observations of a wall with this many tiles.
  void restart(int tiles);
  /// One frame of `step` seconds.
  void observe(std::span<const ComparedPlace> places, const ComparedModel& model, double step,
               const EvidenceParameters& parameters);
  /// After a flip, the tiles exchange their roles, and the evidence changes its sign.
  void reflect(const Wall& wall);
  /// Rotates the field's axes by 180 degrees.
  void rotate_by_180_degrees(const Wall& wall) { wall.rotate_by_180_degrees(std::span(tiles_)); }

  /// 0: no evidence; log(99): 99 in 100 for the reflection.
  double log_odds() const { return log_odds_; }
  /// The contribution of each tile, as of `model`; 0 for a tile that was not in view. With the arguments of the last
  /// observe(), the sum is log_odds().
  void contributions(const ComparedModel& model, const EvidenceParameters& parameters,
                     std::vector<double>& log_odds) const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t tiles = self.tiles_.size();
    archive(self.tiles_, self.log_odds_);
    if constexpr (Archive::kReads) self.check(tiles);
  }

 private:
  struct SeenTile {
    double score = 0.0;  // mean, divided by the gain; positive: for the reflection
    double time = 0.0;   // s in view, at most `settle`; fades out of view
  };
  template <typename Visit, ConstOr<SeenTile> T>
  friend void fields(Visit&& visit, T& tile) {
    visit(tile.score, tile.time);
  }

  void check(std::size_t tiles) const;
  double score_of(std::size_t tile, const ComparedModel& model, const EvidenceParameters& parameters) const;

  std::vector<SeenTile> tiles_;
  double log_odds_ = 0.0;
};

}  // namespace reorient
