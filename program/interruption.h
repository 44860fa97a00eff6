// SPDX-License-Identifier: MIT
// Ctrl-C and similar signals: the first one requests an early end with all outputs, the second one ends the program at
// once.
#pragma once

#include <array>
#include <csignal>

namespace reorient {

/// While it exists, SIGINT, SIGTERM and SIGHUP are stored instead of ending the program. Signals that were ignored
/// before (by nohup, or by a shell that started the program in the background) stay ignored. At most one object at a
/// time.
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

/// The exit code that shells use for a program ended by a signal: 130 for SIGINT.
constexpr int exit_code_of(int signal) { return 128 + signal; }

}  // namespace reorient
