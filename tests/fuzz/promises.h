// SPDX-License-Identifier: MIT
// Requirements of a fuzzer on the tested code. A broken one ends the fuzzer, which saves the input.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include "engine/parameters/utf8.h"

namespace reorient {

inline void require(bool promise, const char* what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

/// Checks the message about an input that is refused.
inline void require_message(std::string_view message) {
  constexpr std::size_t kLongest = 2000;
  require(!message.empty(), "a refusal has a reason");
  require(message.size() <= kLongest, "a refusal can be read");
  require(is_utf8(message), "a refusal is UTF-8");
  for (const char letter : message) {
    const auto code = static_cast<unsigned char>(letter);
    require(code >= ' ' && code != 0x7F, "a refusal is one line, without control characters");
  }
}

/// Processor time of this thread, s.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Limits the processor time during its lifetime. libFuzzer's own limit is of wall-clock time, which depends on the
/// load of the machine.
class Haste {
 public:
  explicit Haste(double seconds) : end_(processor_seconds() + seconds) {}
  ~Haste() { require(processor_seconds() < end_, "an input takes a bounded time"); }
  Haste(const Haste&) = delete;
  Haste& operator=(const Haste&) = delete;

 private:
  double end_;
};

}  // namespace reorient
