// SPDX-License-Identifier: MIT
// What the widest loops of room awareness ask of the processor: they exist in several versions with the same results,
// and the fastest that the processor offers is taken when the program runs.
#pragma once

namespace reorient {

enum class Instructions {
  portable,  ///< nothing
  sse4,      ///< SSE4.2
  avx2,      ///< AVX2
  neon       ///< NEON, which every 64-bit ARM has
};

/// Whether this program has such versions, and this processor runs them.
bool offered(Instructions instructions);
/// The widest that is offered.
Instructions widest_instructions();

}  // namespace reorient
