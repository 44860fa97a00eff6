// SPDX-License-Identifier: MIT
// The log lines of a frame: lines and notes of scripts and the operator, faults, edits, messages to the team.
#pragma once

#include <string>
#include <vector>

#include "workbench/run/observer.h"

namespace reorient {

struct LogLine {
  enum class Level { info, warning, error };

  Level level = Level::info;
  std::string source;  ///< a machine or a script's file; empty if the text contains it, or for a line of the operator
  std::string text;
  std::string file = {};  ///< of a fault: its file
  int line = 0;
  std::string state = {};  ///< of the machine that wrote the line, as "watching/confirmed"; empty: none
};

/// In their order: the behaviors' edits and the scenario's, then the log lines of both.
std::vector<LogLine> log_lines(const FrameRecord& frame, const SceneTruth& scene);

}  // namespace reorient
