// SPDX-License-Identifier: MIT
// What any method is asked that tells a pose from its reflection by the room: so that room awareness and what others
// have proposed can be measured by the same images and the same question.
#pragma once

#include <memory>
#include <optional>

#include "perception/room/room_observation.h"

namespace reorient {

class OrientationCompass {
 public:
  virtual ~OrientationCompass() = default;

  /// One frame of a robot whose believed pose is right. `train` and `evaluate` of the view do not count.
  virtual void learn(const RoomObservation& view) = 0;
  /// A new stretch of looking about begins: what was compared before speaks for nothing any more.
  virtual void begin() = 0;
  /// One frame whose believed pose may be right or the reflection of what is right. Returns how strongly all frames
  /// since begin() speak for the reflection of the believed pose against that pose itself: 0 where they tell nothing,
  /// and always a finite number. Its unit is the method's own.
  virtual double compare(const RoomObservation& view) = 0;

  /// Whether the method's own published rule flips the believed pose after what compare() has seen since begin(). No
  /// value: no rule is known.
  virtual std::optional<bool> wants_flip() const { return std::nullopt; }

  /// With all that it has learned.
  virtual std::unique_ptr<OrientationCompass> clone() const = 0;
};

}  // namespace reorient
