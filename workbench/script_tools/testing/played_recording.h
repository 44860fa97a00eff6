// SPDX-License-Identifier: MIT
// Plays a recording of a run in a scripted test. The script tools cannot read recordings: the caller passes them
// in.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/frame_inputs.h"
#include "engine/record/frame_record.h"
#include "engine/script/script_texts.h"

namespace reorient {

class PlayedRecording {
 public:
  virtual ~PlayedRecording() = default;

  /// Makes the next frame again, of what was recorded and what is added; of that only parameters, scripts' edits and
  /// messages count. Valid until the next call; nullptr: the recording is over. Throws std::runtime_error with one
  /// line.
  virtual const FrameRecord* step(const FrameInputs& added) = 0;
  virtual std::vector<const MachineDefinition*> machines() const = 0;

  /// The first difference of the robot's actions from the recording, in words; nothing: no difference so far.
  virtual std::optional<std::string> first_difference() const = 0;
};

/// With these scripts instead of those that were recorded. Throws std::runtime_error with one line.
using PlayRecording =
    std::function<std::unique_ptr<PlayedRecording>(const std::string& file, const ScriptTexts& scripts)>;

}  // namespace reorient
