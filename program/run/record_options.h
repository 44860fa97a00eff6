// SPDX-License-Identifier: MIT
// The options of `--record` and how it records.
#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace reorient {

struct RecordOptions {
  std::filesystem::path record;  ///< the recording, or the folder of several; empty: none
  std::string record_rotate;     ///< "100MB", "10min"; empty: one file
  // program/run/run_recording.h
  std::string record_images = "lossless";
  std::string view_images = "jpeg:75";
  std::string view_particles = "every:6";
};

/// Adds the options for how `record`, an option of its own, records.
void add_record_options(CLI::App& parser, RecordOptions& options);

}  // namespace reorient
