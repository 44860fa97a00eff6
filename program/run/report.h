// SPDX-License-Identifier: MIT
// The summary of a run, as text and as JSON.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "workbench/run/frame_times.h"
#include "workbench/run/run_summary.h"
#include "workbench/run/timeline.h"

namespace reorient {

/// Facts about a run that only the program knows.
struct RunCircumstances {
  std::string scenario;
  std::string room;
  std::uint64_t seed = 0;
  bool room_awareness = true;
  std::filesystem::path scripts;  ///< folder in use
  std::filesystem::path assets;   ///< folder in use
  double wall_seconds = 0.0;      ///< duration of the run
  std::string digest;
  TimeQuantiles frame_time;                    ///< s in wall-clock time, reloads included
  TimeQuantiles frame_time_without_rendering;  ///< the part of it that is not the simulator's
  int reloads_accepted = 0;
  int reloads_rejected = 0;
  bool is_ended_by_user = false;  ///< before its scenario did, so it is not judged
};

void print_summary(const RunSummary& summary, const RunCircumstances& circumstances, std::ostream& out);

/// Writes beside the file first, then renames. Throws std::runtime_error if that fails.
void write_summary(const RunSummary& summary, const CommandHistory& commands, const RunCircumstances& circumstances,
                   const std::filesystem::path& file);

}  // namespace reorient
