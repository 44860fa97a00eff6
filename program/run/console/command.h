// SPDX-License-Identifier: MIT
// A command of the prompt of a run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/frame_inputs.h"
#include "workbench/run/observer.h"

namespace reorient {

using Words = std::vector<std::string>;

/// The answer of a command, as whole lines. Called after each frame, beginning with the frame of the command; nothing:
/// wait for a later frame. If it throws std::runtime_error, the message is printed instead.
using Reply = std::function<std::optional<std::string>(const FrameRecord& frame, const SceneTruth& scene)>;

/// An answer that does not depend on a frame.
inline Reply at_once(std::string text) {
  return [text = std::move(text)](const FrameRecord&, const SceneTruth&) { return text; };
}

/// One row of the table that dispatch, help and completion read.
struct Command {
  std::string_view name;
  std::string_view arguments;  ///< "NAME VALUE"; optional ones in brackets; "TEXT...": any number of words
  std::string_view help;
  /// Its effect on the next frame. Throws std::runtime_error with one line on bad input.
  std::function<Reply(const Words& arguments, FrameInputs& inputs)> act;
  /// Completions after these arguments; may be empty.
  std::function<Words(const Words& before)> candidates = {};
};

}  // namespace reorient
