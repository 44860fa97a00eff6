// SPDX-License-Identifier: MIT
// Arbitrary datagrams at the port of the GameController, one after another: accepted datagrams contain valid states.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "robots/game_controller.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

void read_datagrams(std::span<const std::byte> bytes) {
  GameController game(5, 3);
  while (!bytes.empty()) {
    // A length, then this number of bytes.
    const std::size_t size = std::min(bytes.size() - 1, std::to_integer<std::size_t>(bytes[0]));
    ExternalInputs external;
    const bool accepted = game.read(bytes.subspan(1, size), external);
    require(accepted || (!external.referee && !external.half_time), "a rejected datagram has no effect");
    if (const std::string complaint = game.take_complaint(); !complaint.empty()) {
      require(!accepted, "only an ignored datagram has a complaint");
      require_message(complaint);
    }
    if (external.referee) {
      require(static_cast<int>(external.referee->state) < enum_count(GameState{}), "the state is known");
      require(!to_string(external.referee->state).empty(), "the state has a name");
    }
    bytes = bytes.subspan(1 + size);
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::read_datagrams({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}
