// SPDX-License-Identifier: MIT
// `reorient replay FILE --live`: a recording in real time for viewers, whose time bar controls it.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

#include "engine/frame.h"
#include "program/recording/recorded_times.h"
#include "program/run/live/live_options.h"
#include "workbench/recording/what_if.h"

namespace reorient {

struct LiveReplayOptions {
  std::filesystem::path file;
  std::filesystem::path scripts;  ///< their root, for services
  RecordedTimes times;
  LiveOptions live;
  /// What-if, from the first frame after each seek on; may be empty.
  std::function<WhatIfChanges(const FrameLoop& engine)> changes;
};

/// Replays until a signal ends it. An Interruption must exist. Returns the exit code. Throws std::runtime_error with
/// one line.
int replay_live(const LiveReplayOptions& options, std::ostream& out, std::ostream& err);

}  // namespace reorient
