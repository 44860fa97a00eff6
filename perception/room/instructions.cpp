// SPDX-License-Identifier: MIT
#include "perception/room/instructions.h"

#include <initializer_list>

namespace reorient {

bool offered(Instructions instructions) {
#if defined(__x86_64__) || defined(__i386__)
  // Both read the processor's features once, at the start of the program.
  if (instructions == Instructions::sse4) return __builtin_cpu_supports("sse4.2") != 0;
  if (instructions == Instructions::avx2) return __builtin_cpu_supports("avx2") != 0;
#elif defined(__aarch64__)
  if (instructions == Instructions::neon) return true;
#endif
  return instructions == Instructions::portable;
}

Instructions widest_instructions() {
  for (const Instructions wide : {Instructions::neon, Instructions::avx2, Instructions::sse4}) {
    if (offered(wide)) return wide;
  }
  return Instructions::portable;
}

}  // namespace reorient
