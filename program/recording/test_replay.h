// SPDX-License-Identifier: MIT
// Recordings for scripted tests.
#pragma once

#include <filesystem>

#include "workbench/script_tools/testing/played_recording.h"

namespace reorient {

/// Files are named from `folder` on, or by their whole path.
PlayRecording recordings_below(std::filesystem::path folder);

}  // namespace reorient
