// SPDX-License-Identifier: MIT
// The common parts of the runs of all robots: progress, prompt, recording, and saving the learned model.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "program/model/model_keeper.h"
#include "program/run/console/live_console.h"
#include "program/run/run_observers.h"
#include "program/run/run_options.h"
#include "program/run/run_recording.h"
#include "program/run/script_edits.h"
#include "program/run/timeline_printer.h"
#include "workbench/run/run_loop.h"

namespace reorient {

class LiveView;

/// A robot and an engine that are ready to run. The objects that it points to must outlive the run.
struct LiveRunParts {
  RunParts parts;                            ///< with the sources and observers of this robot only
  ScriptEdits* edits = nullptr;              ///< nullptr: the run takes neither edits of scripts nor commands
  std::optional<SavedModel> model;           ///< from the file that the options name
  std::uint64_t mounting = 0;                ///< of the cameras, as in as_mounted()
  std::optional<RecorderOptions> recording;  ///< nothing: none
  LiveView* live = nullptr;                  ///< nullptr: none
};

/// One run of one engine. One console may serve several runs, one after the other.
class LiveRun {
 public:
  LiveRun(const RunOptions& options, LiveConsole& console, std::ostream& out, std::ostream& err);

  /// Prints a line for the operator, without breaking the lines of prompt and progress.
  void tell(const std::string& line);

  /// Runs until the robot, the operator, a signal or `live.parts.stop` ends it. An Interruption must exist. The robot's
  /// own observers come before all others, its sources after them. Throws std::runtime_error with one line if the
  /// recording cannot begin.
  RunEnd run(LiveRunParts live);

  // After run():

  /// Prints the contents of the recording, if there is one.
  void end_recording() { recording_->end(out_); }
  /// Adds a line to `failures` if the model's file cannot be written.
  void save_model(std::vector<std::string>& failures);
  /// nullptr without --model.
  const ModelKeeper* model() const { return model_ ? &*model_ : nullptr; }
  const RunLog& log() const { return log_; }

 private:
  const RunOptions& options_;
  LiveConsole& console_;
  std::ostream& out_;
  std::ostream& err_;
  RunLog log_;
  RoomForLog room_for_log_;
  Progress progress_;
  TimelinePrinter timeline_;
  std::optional<ModelKeeper> model_;
  std::optional<RunRecording> recording_;
};

/// Whether a signal came or the operator typed quit.
bool is_ended_by_hand(const LiveConsole& console);

/// Who ended the run: "its user with Ctrl-C"; empty: the run ended by itself. `has_quit`: with the command quit.
std::string user_who_ended_run(bool has_quit);

/// The exit code of the program after its runs.
int exit_code_of_runs(const std::vector<std::string>& failures, bool succeeded = true);

}  // namespace reorient
