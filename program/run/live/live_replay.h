// SPDX-License-Identifier: MIT
// `reorient replay FILE --live`: a recording in real time for viewers, whose time bar controls it.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

#include "engine/frame.h"
#include "engine/frame_inputs.h"
#include "program/recording/recorded_times.h"
#include "program/run/live/live_options.h"

namespace reorient {

struct LiveReplayOptions {
  std::filesystem::path file;
  std::filesystem::path scripts;  ///< their root, for services
  RecordedTimes times;
  LiveOptions live;
  /// What-if: inputs of the first frame after each seek.
  std::function<FrameInputs(const FrameLoop& engine)> changes;
};

/// Replays until a signal ends it. An Interruption must exist. Returns the exit code. Throws std::runtime_error with
/// one line.
int replay_live(const LiveReplayOptions& options, std::ostream& out, std::ostream& err);

}  // namespace reorient
