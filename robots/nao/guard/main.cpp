// SPDX-License-Identifier: MIT
// reorient-nao-guard: the only process that controls the joints of a NAO; it continues to run if the engine ends.
#include <charconv>
#include <cstdio>
#include <exception>
#include <string_view>

#include <unistd.h>

#include "robots/nao/guard/guard_process.h"
#include "robots/nao/guard/shared_body.h"

namespace {

constexpr const char* kHelp =
    "reorient-nao-guard [--lola SOCKET] [--body FILE] [--priority N]\n"
    "\n"
    "Controls the joints of a NAO. Carries out the requests of `reorient run --robot nao` as far as they are safe, "
    "and\n"
    "sits down if they stop. On SIGTERM it sits down and ends.\n"
    "\n"
    "  --lola SOCKET   socket of LoLA, the robot's joint and sensor service (default: /tmp/robocup)\n"
    "  --body FILE     shared memory file for the engine (default: /dev/shm/reorient-nao-UID)\n"
    "  --priority N    real-time priority if permitted, 1 to 99; 0: no real time (default: 20)\n";

int complain(const char* what, const char* argument) {
  std::fprintf(stderr, "reorient-nao-guard: %s: %s; see reorient-nao-guard --help\n", argument, what);
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  reorient::nao::GuardOptions options;
  options.body = reorient::nao::default_body_file();
  for (int i = 1; i < count; ++i) {
    const std::string_view name = arguments[i];
    if (name == "--help" || name == "-h") {
      std::fputs(kHelp, stdout);
      return 0;
    }
    if (name != "--lola" && name != "--body" && name != "--priority") return complain("unknown option", arguments[i]);
    if (i + 1 == count || *arguments[i + 1] == '\0') return complain("expected a value", arguments[i]);
    const std::string_view value = arguments[++i];
    if (name == "--lola") options.lola = value;
    if (name == "--body") options.body = value;
    if (name == "--priority") {
      const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), options.priority);
      if (error != std::errc() || end != value.data() + value.size() || options.priority < 0 || options.priority > 99)
        return complain("expected a number from 0 to 99", "--priority");
    }
  }
  try {
    reorient::nao::run_guard(options, STDERR_FILENO);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "reorient-nao-guard: %s\n", error.what());
    return 2;
  }
  return 0;
}
