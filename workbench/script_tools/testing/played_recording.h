// SPDX-License-Identifier: MIT
// Plays a recording of a run in a scripted test. The script tools cannot read recordings, so the caller provides them.
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

  /// Runs the next recorded frame with additional inputs, of which only parameters, edits of scripts and messages are
  /// used. Valid until the next call; nullptr at the end of the recording. Throws std::runtime_error with one line.
  virtual const FrameRecord* step(const FrameInputs& added) = 0;
  virtual std::vector<const MachineDefinition*> machines() const = 0;

  /// The first difference of the robot's actions from the recording, as text; empty: no difference so far.
  virtual std::optional<std::string> first_difference() const = 0;
};

/// Opens a recording, to be run with these scripts instead of the recorded ones. Once `stop` returns true, this and the
/// steps of the recording end early with an exception. Throws std::runtime_error with one line.
using PlayRecording = std::function<std::unique_ptr<PlayedRecording>(
    const std::string& file, const ScriptTexts& scripts, const std::function<bool()>& stop)>;

}  // namespace reorient
