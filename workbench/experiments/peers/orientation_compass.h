// SPDX-License-Identifier: MIT
// The interface of methods that distinguish a pose from the mirrored pose by the room, so that room awareness and its
// peers can be measured on the same images.
#pragma once

#include <memory>
#include <optional>

#include "perception/room/room_observation.h"

namespace reorient {

class OrientationCompass {
 public:
  virtual ~OrientationCompass() = default;

  /// Learns one frame of a robot whose believed pose is right. Ignores `train` and `evaluate` of the view.
  virtual void learn(const RoomObservation& view) = 0;
  /// A new period of looking around begins: clears the evidence of earlier frames.
  virtual void begin() = 0;
  /// Compares one frame whose believed pose may be right or mirrored. Returns the evidence of all frames since begin()
  /// for the mirrored pose against the believed pose: 0 without evidence, always finite, in the method's own unit.
  virtual double compare(const RoomObservation& view) = 0;

  /// Whether the method's published rule flips the believed pose after the frames since begin(). No value: no rule is
  /// known.
  virtual std::optional<bool> wants_flip() const { return std::nullopt; }

  /// A copy with everything that it has learned.
  virtual std::unique_ptr<OrientationCompass> clone() const = 0;
};

}  // namespace reorient
