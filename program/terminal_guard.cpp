// SPDX-License-Identifier: MIT
#include "program/terminal_guard.h"

#include <cerrno>

#include <termios.h>
#include <unistd.h>

namespace reorient {
namespace {

// The only variables that signal handlers use.
volatile std::sig_atomic_t guarded = -1;  // descriptor
volatile std::sig_atomic_t stopped = 0;
termios found;
termios own;

void end(int signal) {
  TerminalGuard::give_back();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void handle_stop();

void stop(int signal) {
  const int error = errno;
  TerminalGuard::give_back();
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // the program is stopped here
  handle_stop();
  stopped = 1;
  errno = error;
}

void handle_stop() {
  struct sigaction action {};
  action.sa_handler = stop;
  action.sa_flags = SA_RESTART | SA_NODEFER;  // so that it can be stopped within the handler
  sigemptyset(&action.sa_mask);
  sigaction(SIGTSTP, &action, nullptr);
}

}  // namespace

bool is_in_foreground(int descriptor) { return isatty(descriptor) != 1 || tcgetpgrp(descriptor) == getpgrp(); }

TerminalGuard::TerminalGuard(int descriptor) {
  if (tcgetattr(descriptor, &found) != 0) return;
  own = found;
  stopped = 0;
  guarded = descriptor;
  struct sigaction action {};
  action.sa_handler = end;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kFatal.size(); ++i) {
    sigaction(kFatal[i], nullptr, &before_[i]);
    if (before_[i].sa_handler == SIG_DFL) sigaction(kFatal[i], &action, nullptr);
  }
  sigaction(SIGTSTP, nullptr, &before_stop_);
  if (before_stop_.sa_handler == SIG_DFL) handle_stop();
}

TerminalGuard::~TerminalGuard() {
  if (guarded < 0) return;
  give_back();
  guarded = -1;
  for (std::size_t i = 0; i < kFatal.size(); ++i) sigaction(kFatal[i], &before_[i], nullptr);
  sigaction(SIGTSTP, &before_stop_, nullptr);
}

void TerminalGuard::remember_own_modes() {
  if (guarded >= 0) tcgetattr(guarded, &own);
}

bool TerminalGuard::came_back() {
  if (guarded < 0 || stopped == 0 || !is_in_foreground(guarded)) return false;
  stopped = 0;
  tcsetattr(guarded, TCSANOW, &own);
  return true;
}

void TerminalGuard::give_back() noexcept {
  if (guarded >= 0 && tcgetpgrp(guarded) == getpgrp()) tcsetattr(guarded, TCSANOW, &found);
}

}  // namespace reorient
