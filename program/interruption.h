// SPDX-License-Identifier: MIT
// Ctrl-C and its kin: the first asks the program to end what it does and to tell what there is, the second ends it at
// once.
#pragma once

#include <array>
#include <csignal>

namespace reorient {

/// While it lives, SIGINT, SIGTERM and SIGHUP are noted instead of ending the program. What was ignored before (by
/// nohup, by a shell that started this in the background) stays ignored. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The first signal that came; 0: none.
  static int signal();

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
};

/// As shells tell that a signal ended a program: 130 for SIGINT.
constexpr int exit_code_of(int signal) { return 128 + signal; }

}  // namespace reorient
