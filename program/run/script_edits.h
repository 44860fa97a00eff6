// SPDX-License-Identifier: MIT
// Edits of scripts on the disk, as inputs of a run. A thread looks for them, because the folder may be a share that is
// slow or hangs.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "workbench/files/script_files.h"
#include "workbench/run/run_loop.h"

namespace reorient {

class ScriptEdits : public InputSource {
 public:
  /// Waits for the disk, and returns the edits since the last call.
  using Look = std::function<std::vector<ScriptEdit>()>;

  /// Reads the scripts; throws std::runtime_error with one line if that is not possible.
  explicit ScriptEdits(const std::filesystem::path& root);
  /// `texts`: before the first edits. `look` is called by the thread, which may outlive this object if a call hangs.
  ScriptEdits(ScriptTexts texts, Look look);
  /// Waits a moment for the thread, and then leaves it alone.
  ~ScriptEdits() override;
  ScriptEdits(const ScriptEdits&) = delete;
  ScriptEdits& operator=(const ScriptEdits&) = delete;

  /// The latest texts. For an engine that starts with them: their edits are not added to a frame.
  const ScriptTexts& texts();
  /// The texts of which the engine knows the edits.
  const ScriptTexts* known() const { return &texts_; }
  /// Edits between the `known` scripts and texts(), while no watcher ran, come with the next frame.
  void add_missed(const ScriptTexts& known);

  /// Does not wait for the disk.
  void add_to(FrameInputs& inputs) override;

 private:
  struct Shared;

  explicit ScriptEdits(const std::shared_ptr<ScriptFiles>& files);
  static void look_for_edits(Shared& shared, const Look& look);
  std::vector<ScriptEdit> found();

  ScriptTexts texts_;  // with all edits that were taken from the thread
  std::vector<ScriptEdit> missed_;
  std::shared_ptr<Shared> shared_;
  std::thread thread_;
};

}  // namespace reorient
