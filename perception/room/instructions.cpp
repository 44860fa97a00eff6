#include "perception/room/instructions.h"

namespace reorient {

bool offered(Instructions instructions) {
#if defined(__x86_64__) || defined(__i386__)
  // Both ask the processor once, when the program starts.
  if (instructions == Instructions::sse4) return __builtin_cpu_supports("sse4.2") != 0;
  if (instructions == Instructions::avx2) return __builtin_cpu_supports("avx2") != 0;
#endif
  return instructions == Instructions::portable;
}

Instructions widest_instructions() {
  if (offered(Instructions::avx2)) return Instructions::avx2;
  return offered(Instructions::sse4) ? Instructions::sse4 : Instructions::portable;
}

}  // namespace reorient
