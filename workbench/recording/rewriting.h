// SPDX-License-Identifier: MIT
// Recordings made of recordings.
#pragma once

#include <cstdint>
#include <filesystem>

#include "workbench/recording/recording.h"

namespace reorient {

struct Rewritten {
  std::uint64_t frames = 0;
  double first_time = 0.0, last_time = 0.0;  ///< s of the robot, of its first and its last frame
  std::uint64_t lost = 0;                    ///< frames that were there once, between these or as the end tells
};

/// Whether messages for viewers are copied, too.
enum class Views { kept, left_out };

/// All that can be read, in a file that is whole. Throws std::runtime_error with one line.
Rewritten recover_recording(Recording& recording, const std::filesystem::path& file);

/// The frames from `from` to `to` (s of the robot). It begins with the state of the engine at `from`, which is found by
/// making the frames before it again; where that cannot be done, it begins with the state before, or the first after
/// it. Throws std::runtime_error with one line: there are none.
Rewritten cut_recording(Recording& recording, double from, double to, const std::filesystem::path& file,
                        Views views = Views::kept);

}  // namespace reorient
