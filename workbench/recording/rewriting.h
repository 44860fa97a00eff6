// SPDX-License-Identifier: MIT
// Creates recordings from recordings.
#pragma once

#include <cstdint>
#include <filesystem>

#include "workbench/recording/recording.h"

namespace reorient {

struct Rewritten {
  std::uint64_t frames = 0;
  double first_time = 0.0, last_time = 0.0;  ///< times of the first and the last frame, s of the robot
  Recording::Losses losses;                  ///< of the copied part
};

/// Whether messages for viewers are copied, too.
enum class Views { kept, left_out };

/// Copies all readable data to a complete file. Throws std::runtime_error with one line.
Rewritten recover_recording(Recording& recording, const std::filesystem::path& file);

/// Copies the frames from `from` to `to` (s of the robot). It begins with the state of the engine at `from`, which is
/// computed by replaying the frames before it. If that is not possible, it begins with the last state before, or the
/// first after it. Throws std::runtime_error with one line if there are no such frames.
Rewritten cut_recording(Recording& recording, double from, double to, const std::filesystem::path& file,
                        Views views = Views::kept);

}  // namespace reorient
