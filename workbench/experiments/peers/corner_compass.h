// SPDX-License-Identifier: MIT
// Corner landmarks: the rule by which a team of RoboCup's humanoid league determines the side of the field since July
// 2026 (NUbots, pull request 1823 of NUbots/NUbots), from its published description, not from its code. docs/peers.md
// lists what is known of it and what is chosen here.
#pragma once

#include "workbench/experiments/peers/corner_decision.h"
#include "workbench/experiments/peers/corner_map.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

struct CornerCompassParameters {
  int contrast = 6;
  int corners = 200;
  CornerMapParameters map;
  CornerDecisionParameters decision;
};
template <typename Visit>
void describe(CornerCompassParameters& p, Visit&& visit) {
  visit("contrast", p.contrast, 1, 254, "", "smallest contrast of a corner, in steps of luma from 0 to 255");
  visit("corners", p.corners, 1, 10000, "", "largest number of corners of a frame; those with most contrast are used");
  describe(p.map, visit);
  describe(p.decision, visit);
}

/// It learns a map of corners with their positions. It compares how well each frame's corners fit the map under the
/// believed pose and under the mirrored pose; the score is the accumulated log-likelihood ratio of the mirrored pose.
class CornerCompass : public OrientationCompass {
 public:
  explicit CornerCompass(const CornerCompassParameters& parameters = {});

  void learn(const RoomObservation& view) override;
  void begin() override { decision_.restart(); }
  double compare(const RoomObservation& view) override;
  std::optional<bool> wants_flip() const override { return decision_.wants_flip(); }
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<CornerCompass>(*this); }

 private:
  CornerCompassParameters parameters_;
  CornerMap map_;
  CornerDecision decision_;
};

}  // namespace reorient
