// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/room_compass.h"

namespace reorient {

void RoomCompass::learn(const RoomObservation& view) {
  RoomObservation learned = view;
  learned.train = true;
  learned.evaluate = false;
  awareness_.update(learned);
}

double RoomCompass::compare(const RoomObservation& view) {
  RoomObservation compared = view;
  compared.train = false;
  compared.evaluate = true;
  const Confidences& confidences = awareness_.update(compared);
  result_ = score_ == RoomScore::evidence ? confidences.evidence : confidences.opposite - confidences.current;
  return result_;
}

std::optional<bool> RoomCompass::wants_flip() const {
  // Thresholds of the shipped behaviors, without their other conditions: scripts/lib/decision.lua for a pose that was
  // confirmed, ln(240 / 0.02), and scripts/behaviors/paper/paper_orientation.lua.
  constexpr double kEvidence = 9.39;
  constexpr double kLead = 0.3;
  return result_ > (score_ == RoomScore::evidence ? kEvidence : kLead);
}

}  // namespace reorient
