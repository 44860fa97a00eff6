// SPDX-License-Identifier: MIT
// The guard as a process: connects to LoLA, also after a lost connection, and answers each of its packets at once.
#pragma once

#include <filesystem>
#include <string>

namespace reorient::nao {

struct GuardOptions {
  std::filesystem::path lola = "/tmp/robocup";  ///< LoLA's socket
  std::filesystem::path body;                   ///< the file that is shared with the engine
  int priority = 20;                            ///< real-time priority if permitted; 0: no real time
};

/// Runs until SIGINT, SIGTERM or SIGHUP. Then the robot sits down, which takes 3 s, and becomes soft; after 5 s also if
/// an operator holds it so that it cannot sit down. A second signal ends the guard at once. Writes lines of what
/// happens to the file descriptor `out`. Throws std::runtime_error with one line if it cannot start.
void run_guard(const GuardOptions& options, int out);

}  // namespace reorient::nao
