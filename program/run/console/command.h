// SPDX-License-Identifier: MIT
// What a person can ask for at the prompt of a run.
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

/// What a command says, as whole lines, to be asked after each frame from its own on; nothing: it waits for a later
/// one. A std::runtime_error that it throws is told instead.
using Reply = std::function<std::optional<std::string>(const FrameRecord& frame, const SceneTruth& scene)>;

/// An answer that no frame changes.
inline Reply at_once(std::string text) {
  return [text = std::move(text)](const FrameRecord&, const SceneTruth&) { return text; };
}

/// One row of the table that dispatch, help and completion read.
struct Command {
  std::string_view name;
  std::string_view arguments;  ///< "NAME VALUE"; in brackets what may be left out; "TEXT...": any number of words
  std::string_view help;
  /// What it does to the frame that begins. Throws std::runtime_error with one line on bad input.
  std::function<Reply(const Words& arguments, FrameInputs& inputs)> act;
  /// What may stand behind these arguments; may be empty.
  std::function<Words(const Words& before)> candidates = {};
};

}  // namespace reorient
