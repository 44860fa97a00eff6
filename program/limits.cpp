// SPDX-License-Identifier: MIT
#include "program/limits.h"

#include <new>

#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>

namespace reorient {
namespace {

constexpr rlim_t kKiB = 1024, kMiB = 1024 * kKiB;

/// Nothing is allocated when it is thrown: the text is written at the start.
class NoMemory : public std::bad_alloc {
 public:
  const char* what() const noexcept override { return memory_shortage(); }
};

std::string memory_text() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return "expected more memory, found none left on this computer";
  return fmt::format(
      "expected more memory, found none left of {} KiB, the limit of this process; raise it with 'ulimit -v'",
      limit.rlim_cur / kKiB);
}

}  // namespace

std::string stack_shortage() {
  constexpr rlim_t kLeast = kMiB;  // several times as much as any command uses
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kLeast) return {};  // unlimited: the largest number
  return fmt::format("expected a stack of at least {} KiB, found a limit of {} KiB; raise it with 'ulimit -s 8192'",
                     kLeast / kKiB, limit.rlim_cur / kKiB);
}

const char* memory_shortage() {
  static const std::string text = memory_text();
  return text.c_str();
}

void name_memory_shortage() {
  memory_shortage();
  std::set_new_handler([] { throw NoMemory(); });
}

}  // namespace reorient
