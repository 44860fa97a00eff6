// SPDX-License-Identifier: MIT
// Waits of tests: for an event, never for a fixed time in the hope that the event has happened by then.
#pragma once

#include <chrono>
#include <thread>

namespace reorient {

/// Limit of every wait. Only a test that fails waits so long, so the limit leaves room for a starved machine.
#ifdef REORIENT_EMULATOR
inline constexpr std::chrono::seconds kWaitLimit{1200};
#else
inline constexpr std::chrono::seconds kWaitLimit{120};
#endif

/// Calls `happened()` until it returns true, with a pause between two calls. Returns false if it stayed false for
/// kWaitLimit.
template <typename Event>
bool await(const Event& happened, std::chrono::milliseconds pause = std::chrono::milliseconds(5)) {
  const auto end = std::chrono::steady_clock::now() + kWaitLimit;
  while (!happened()) {
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(pause);
  }
  return true;
}

/// Waits at least this time: a random time before a signal, or the pause of a program between two actions. A test must
/// not depend on how much longer the wait takes, nor on what another program does meanwhile.
inline void let_time_pass(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

}  // namespace reorient
