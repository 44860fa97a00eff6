// SPDX-License-Identifier: MIT
// Processor features that the inner loops of room awareness use. The loops have several versions with the same results.
// The fastest version that the processor supports is selected at run time.
#pragma once

namespace reorient {

enum class Instructions {
  portable,  ///< no optional instructions
  sse4,      ///< SSE4.2
  avx2,      ///< AVX2
  neon       ///< NEON, part of every 64-bit ARM processor
};

/// Whether this program contains such versions and this processor supports them.
bool offered(Instructions instructions);
/// The widest supported version.
Instructions widest_instructions();

}  // namespace reorient
