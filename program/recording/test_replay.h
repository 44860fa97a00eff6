// SPDX-License-Identifier: MIT
// Recordings for scripted tests.
#pragma once

#include <filesystem>

#include "workbench/script_tools/testing/played_recording.h"

namespace reorient {

/// File names are relative to `folder`, or absolute.
PlayRecording recordings_below(std::filesystem::path folder);

}  // namespace reorient
