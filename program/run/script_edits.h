// SPDX-License-Identifier: MIT
// Edits of scripts on the disk, as inputs of a run.
#pragma once

#include <filesystem>
#include <vector>

#include "workbench/files/script_files.h"
#include "workbench/run/run_loop.h"

namespace reorient {

class ScriptEdits : public InputSource {
 public:
  /// Reads the scripts; throws std::runtime_error with one line if that is not possible.
  explicit ScriptEdits(const std::filesystem::path& root) : files_(root) {}

  const ScriptTexts& texts() const { return files_.texts(); }
  /// Edits since the scripts were `known`, while no watcher ran, come with the next frame.
  void add_missed(const ScriptTexts& known) { missed_ = edits_between(known, files_.texts()); }

  void add_to(FrameInputs& inputs) override;

 private:
  ScriptFiles files_;
  std::vector<ScriptEdit> missed_;
};

}  // namespace reorient
