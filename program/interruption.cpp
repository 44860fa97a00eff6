// SPDX-License-Identifier: MIT
#include "program/interruption.h"

#include <atomic>

#include "program/terminal_guard.h"

namespace reorient {
namespace {

std::atomic<int> came{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait");

void note(int signal) {
  int none = 0;
  if (came.compare_exchange_strong(none, signal)) return;
  // The second signal ends the program at once.
  TerminalGuard::give_back();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

Interruption::Interruption() {
  came = 0;
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

int Interruption::signal() { return came; }

}  // namespace reorient
