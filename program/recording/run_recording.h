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

class RunRecording {
 public:
  /// `part`: of a program that runs several engines one after the other, into match.mcap, match-2.mcap, match-3.mcap;
  /// where one is there already, the next number.
  RunRecording(std::optional<RecorderOptions> options, std::function<void(const std::string&)> tell, int part = 1);

  /// nullptr: nothing is recorded.
  Observer* observer() { return recorder_ ? &*recorder_ : nullptr; }

  /// Ends the file, and says what is in it.
  void end(std::ostream& out);

 private:
  std::filesystem::path file_;  // the first
  std::optional<Recorder> recorder_;
};

}  // namespace reorient
