// SPDX-License-Identifier: MIT
// The percepts at the end of a client's frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "robots/companion/message.h"
#include "robots/external_percepts.h"

namespace reorient {

/// The valid percepts of a message, and the number of the others.
struct PerceptMessage {
  std::vector<ExternalPercept> list;
  std::uint32_t dropped = 0;
  std::string mistake;  ///< in the first one that was dropped: "percepts[3]: ball: radius: expected ..."

  void clear() {
    list.clear();
    dropped = 0;
    mistake.clear();
  }
};

/// Removes reorient_percepts and its percepts from the front. Throws BadMessage for a wrong size, too many percepts,
/// and for unknown types, spaces and bits. Drops percepts with invalid numbers.
void read_percepts(std::span<const std::byte>& bytes, PerceptMessage& message);

}  // namespace reorient
