// SPDX-License-Identifier: MIT
// Requirements of a fuzzer on the tested code: a broken one ends the fuzzer, and the input is saved.
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

/// What a person reads about an input that is refused.
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

/// Of this thread.
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What happens while it lives is done soon. libFuzzer's own limit is one of wall-clock time, and a busy machine may
/// take any amount of that.
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
