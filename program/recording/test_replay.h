// SPDX-License-Identifier: MIT
// Recordings for scripted tests.
#pragma once

#include <filesystem>

#include "workbench/script_tools/testing/played_recording.h"

namespace reorient {

/// File names are relative to the tests' folder of the scripts' root. A test may read no file outside of the root.
PlayRecording recordings_below(const std::filesystem::path& scripts_root);

}  // namespace reorient
