// SPDX-License-Identifier: MIT
// Recorded frames in order: of a file, or those that a run keeps in memory.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "geometry/image.h"
#include "workbench/recording/frame_entry.h"

namespace reorient {

struct RecordedFrame {
  FrameEntry entry;                ///< image_is_exact is false for images that are missing
  std::array<Image, 2> images;     ///< valid if entry.image_is_exact
  std::vector<std::byte> state;    ///< of the engine before the frame; empty: not recorded here
  bool follows = false;            ///< the previously read frame is its predecessor
  std::vector<ViewMessage> views;  ///< messages for viewers, if the source reads them, too
};

/// Tolerance in s, because users read and enter times of a recording with two decimals.
inline constexpr double kReadingError = 0.01;

class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// The next frame; false after the last one.
  virtual bool next(RecordedFrame& frame) = 0;
  /// Makes the next frame the latest one with a state of the engine at or before `time` (s of the robot), or else the
  /// first one with a state. False: no frame has a state.
  virtual bool go_to(double time) = 0;
  /// Adds a damage that a reader of the frame has found.
  virtual void add_damage(const RecordedFrame& frame, const std::string& what) = 0;
};

}  // namespace reorient
