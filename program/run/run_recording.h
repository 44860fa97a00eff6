// SPDX-License-Identifier: MIT
// The recording of a run: `--record FILE`.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "program/run/run_options.h"
#include "workbench/recording/recorder.h"

namespace reorient {

/// "jpeg:75": 75, "none": 0. `option`: its name. Throws std::runtime_error with one line.
int viewer_image_quality(const std::string& mode, const std::string& option);

/// The options of `--record` and related options; nothing: no recording. `venue`: for the user. Throws
/// std::runtime_error with one line, also if the file cannot be written.
std::optional<RecorderOptions> recorder_options(const RunOptions& options, const std::string& venue);
/// The options of one recording of `file`, without a description. `further_parts_are_refused`: for a run whose files
/// replace earlier ones. Throws the same.
RecorderOptions recorder_options(const RecordOptions& options, const std::filesystem::path& file,
                                 bool further_parts_are_refused);

/// Throws std::runtime_error with one line if the file exists and is not a recording, so that it is not lost. `option`:
/// the option that names it.
void require_new_or_recording(const std::filesystem::path& file, const std::string& option);

/// A supervisor that restarts the program, for another client or after a crash, cannot choose a name: keep the old
/// recording, and write match-2.mcap or the next free number.
enum class EarlierRecording { is_replaced, stays };

class RunRecording {
 public:
  /// `earlier`: treatment of an existing file.
  RunRecording(std::optional<RecorderOptions> options, std::function<void(const std::string&)> tell,
               EarlierRecording earlier);

  /// nullptr: nothing is recorded.
  Observer* observer() { return recorder_ ? &*recorder_ : nullptr; }

  /// Recorder::wait_for_thread(); true if nothing is recorded.
  bool wait_for_thread(double seconds) { return !recorder_ || recorder_->wait_for_thread(seconds); }

  /// Ends the file, and prints what it contains. `digest`: of the recorded frames; empty: it is not printed.
  void end(std::ostream& out, const std::string& digest = "");

 private:
  std::filesystem::path file_;  // the first
  std::optional<Recorder> recorder_;
};

}  // namespace reorient
