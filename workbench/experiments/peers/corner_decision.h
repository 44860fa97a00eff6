// SPDX-License-Identifier: MIT
// The rule by which corner landmarks flip the believed pose. The constants are those that a team of RoboCup's humanoid
// league published in 2026 (docs/peers.md).
#pragma once

#include "workbench/experiments/peers/corner_map.h"

namespace reorient {

struct CornerDecisionParameters {
  double forgetting = 0.98;
  double frame_limit = 6.0;
  double total_limit = 40.0;
  double flip_at = -25.0;
  int hold = 10;
  int least_matches = 3;
  double least_ratio = 2.0;
  double least_coverage = 0.5;
};
template <typename Visit>
void describe(CornerDecisionParameters& p, Visit&& visit) {
  visit("forgetting", p.forgetting, 0.0, 1.0, "", "factor of the log-likelihood ratio from one frame to the next");
  visit("frame_limit", p.frame_limit, 0.0, 1000.0, "", "largest change of the log-likelihood ratio by one frame");
  visit("total_limit", p.total_limit, 0.0, 10000.0, "", "largest log-likelihood ratio");
  visit("flip_at", p.flip_at, -10000.0, 0.0, "",
        "log-likelihood ratio of the believed pose against its mirrored pose, up to which the pose may be flipped");
  visit("hold", p.hold, 1, 10000, "", "number of successive frames in which all conditions of a flip have to hold");
  visit("least_matches", p.least_matches, 0, 1000, "", "smallest number of matches under the mirrored pose for a flip");
  visit("least_ratio", p.least_ratio, 0.0, 1000.0, "",
        "smallest ratio of matches under the mirrored pose to those under the believed pose for a flip");
  visit("least_coverage", p.least_coverage, 0.0, 1.0, "", "smallest coverage of the circle by the map for a flip");
}

class CornerDecision {
 public:
  explicit CornerDecision(const CornerDecisionParameters& parameters) : parameters_(parameters) {}

  void restart();
  /// Adds one frame: its fits with the map under the believed pose and under the mirrored pose.
  void update(const CornerFit& believed, const CornerFit& mirrored, double coverage);

  /// Log-likelihood ratio of the believed pose against the mirrored pose: negative values support the mirrored pose.
  double ratio() const { return ratio_; }
  bool wants_flip() const { return held_ >= parameters_.hold; }

 private:
  CornerDecisionParameters parameters_;
  double ratio_ = 0.0;
  int held_ = 0;  // frames
};

}  // namespace reorient
