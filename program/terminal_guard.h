// SPDX-License-Identifier: MIT
// The terminal as it was found, given back whatever ends or stops the program.
#pragma once

#include <array>
#include <csignal>

namespace reorient {

/// While it lives, the terminal is in modes of our own. It gets its own back in the destructor, before a signal ends
/// the program, and for as long as Ctrl-Z stops it. One at a time; SIGKILL alone is not met.
class TerminalGuard {
 public:
  /// The modes of `descriptor`, a terminal, are those to be given back.
  explicit TerminalGuard(int descriptor);
  ~TerminalGuard();
  TerminalGuard(const TerminalGuard&) = delete;
  TerminalGuard& operator=(const TerminalGuard&) = delete;

  /// The modes of now are our own.
  static void remember_own_modes();
  /// Our own modes again, where the program was stopped since the last call and is in the foreground again.
  static bool came_back();

  /// In a signal handler, too. Does nothing where there is no guard.
  static void give_back() noexcept;

 private:
  static constexpr std::array kFatal{SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};
  std::array<struct sigaction, kFatal.size()> before_{};
  struct sigaction before_stop_ {};
};

/// To read a terminal that another process group has, or to set its modes, would stop this one: a run in the background
/// must not. True for what is no terminal, too.
bool is_in_foreground(int descriptor);

}  // namespace reorient
