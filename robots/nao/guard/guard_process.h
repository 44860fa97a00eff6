// SPDX-License-Identifier: MIT
// The guard as a process: connects to LoLA again and again, and answers each of its packets at once.
#pragma once

#include <filesystem>
#include <string>

namespace reorient::nao {

struct GuardOptions {
  std::filesystem::path lola = "/tmp/robocup";  ///< LoLA's socket
  std::filesystem::path body;                   ///< the file that is shared with the engine
  int priority = 20;                            ///< of real time, where that is allowed; 0: none is asked for
};

/// Until SIGINT, SIGTERM or SIGHUP: then it sits down, which takes 3 s, and lets go, after 5 s also where somebody
/// holds the robot so that it cannot sit down; a second one ends it at once. Tells what happens in lines to the file
/// descriptor `out`. Throws std::runtime_error with one line where it cannot begin.
void run_guard(const GuardOptions& options, int out);

}  // namespace reorient::nao
