// SPDX-License-Identifier: MIT
// Room awareness with the interface of its peers.
#pragma once

#include <cstdint>

#include "perception/room/room_awareness.h"
#include "workbench/experiments/peers/orientation_compass.h"

namespace reorient {

/// Its two scores.
enum class RoomScore {
  evidence,     ///< its log-odds
  confidences,  ///< the smoothed confidence in the reflection minus that in the pose: the paper's criterion
};

class RoomCompass : public OrientationCompass {
 public:
  RoomCompass(const RoomParameters& parameters, RoomScore score, std::uint64_t seed)
      : awareness_(parameters, seed), score_(score) {}

  void learn(const RoomObservation& view) override;
  void begin() override {
    awareness_.restart();
    result_ = 0.0;
  }
  double compare(const RoomObservation& view) override;
  std::optional<bool> wants_flip() const override;
  std::unique_ptr<OrientationCompass> clone() const override { return std::make_unique<RoomCompass>(*this); }

 private:
  RoomAwareness awareness_;
  RoomScore score_;
  double result_ = 0.0;  // result of the last compare() since begin()
};

}  // namespace reorient
