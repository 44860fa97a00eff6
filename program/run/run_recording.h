// SPDX-License-Identifier: MIT
// The recording of a run, where one is wanted: `--record FILE`.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "program/run/run_options.h"
#include "workbench/recording/recorder.h"

namespace reorient {

/// What `--record` and its like ask for; nothing: no recording. `venue`: for people. Throws std::runtime_error with one
/// line, also where the file could not be written.
std::optional<RecorderOptions> recorder_options(const RunOptions& options, const std::string& venue);

/// Throws std::runtime_error with one line where a file is there that is no recording: it is not to be lost. `option`:
/// what names it.
void require_new_or_recording(const std::filesystem::path& file, const std::string& option);

/// A robot's program is begun again by something that cannot choose a name, for another client or after a crash: what
/// was recorded stays, and match-2.mcap is next, or the next number that is free.
enum class EarlierRecording { is_replaced, stays };

class RunRecording {
 public:
  /// `earlier`: what becomes of a file that is there already.
  RunRecording(std::optional<RecorderOptions> options, std::function<void(const std::string&)> tell,
               EarlierRecording earlier);

  /// nullptr: nothing is recorded.
  Observer* observer() { return recorder_ ? &*recorder_ : nullptr; }

  /// Ends the file, and says what is in it.
  void end(std::ostream& out);

 private:
  std::filesystem::path file_;  // the first
  std::optional<Recorder> recorder_;
};

}  // namespace reorient
