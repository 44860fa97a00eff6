// SPDX-License-Identifier: MIT
// Restores the modes of the terminal when the program ends or is stopped.
#pragma once

#include <array>
#include <csignal>

namespace reorient {

/// While it exists, the terminal has the modes of the program. The old modes are restored by the destructor, before a
/// signal ends the program, and while Ctrl-Z stops it. At most one object at a time. SIGKILL cannot be handled.
class TerminalGuard {
 public:
  /// Stores the modes of `descriptor`, a terminal, to restore them later.
  explicit TerminalGuard(int descriptor);
  ~TerminalGuard();
  TerminalGuard(const TerminalGuard&) = delete;
  TerminalGuard& operator=(const TerminalGuard&) = delete;

  /// Stores the present modes as those of the program.
  static void remember_own_modes();
  /// Sets the program's modes again, if it was stopped since the last call and is in the foreground again.
  static bool came_back();

  /// May be called in a signal handler. Does nothing without a guard.
  static void give_back() noexcept;

 private:
  static constexpr std::array kFatal{SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
  std::array<struct sigaction, kFatal.size()> before_{};
  struct sigaction before_stop_ {};
};

/// Reading a terminal of another process group, or setting its modes, would stop this process, as a run in the
/// background must not. True also for a descriptor that is not a terminal.
bool is_in_foreground(int descriptor);

}  // namespace reorient
