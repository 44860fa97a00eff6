// SPDX-License-Identifier: MIT
#include "engine/world/room_status.h"

namespace reorient {

std::string_view to_string(RoomStatus status) {
  constexpr std::string_view kNames[kRoomStatuses] = {"usable",    "off",  "resting", "unlearned",
                                                      "symmetric", "lost", "fresh"};
  return kNames[static_cast<std::size_t>(status)];
}

RoomStatus room_status(const World& world, const RoomStatusParameters& p) {
  if (!world.room_awareness) return RoomStatus::off;
  if (!world.evaluating) return RoomStatus::resting;
  if (world.confidence.coverage < p.coverage) return RoomStatus::unlearned;
  const bool looks_the_same = world.confidence.paired > 0.0 && world.confidence.distinctiveness < p.distinctiveness;
  if (looks_the_same || world.confidence.separability < p.separability) return RoomStatus::symmetric;
  if (world.recovery_probability > p.recovery_probability) return RoomStatus::lost;
  if (world.confidence.age < p.age) return RoomStatus::fresh;
  return RoomStatus::usable;
}

bool can_tell(RoomStatus status) {
  return status == RoomStatus::usable || status == RoomStatus::lost || status == RoomStatus::fresh;
}

}  // namespace reorient
