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

class RunRecording {
 public:
  /// Records nothing where the options name no file. `venue`: for people. `part`: of a program that runs several
  /// engines one after the other, into match.mcap, match-2.mcap, match-3.mcap. Throws std::runtime_error with one line.
  RunRecording(const RunOptions& options, const std::string& venue, std::function<void(const std::string&)> tell,
               int part = 1);

  /// nullptr: nothing is recorded.
  Observer* observer() { return recorder_ ? &*recorder_ : nullptr; }

  /// Ends the file, and says what is in it.
  void end(std::ostream& out);

 private:
  std::filesystem::path file_;
  std::optional<Recorder> recorder_;
};

/// "lossless": 1, "every:5": 5, "none": 0. Throws std::runtime_error with one line.
int images_every(const std::string& option);

}  // namespace reorient
