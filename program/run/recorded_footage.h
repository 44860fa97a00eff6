// SPDX-License-Identifier: MIT
// A recording of the program as footage: images that a robot or the simulator recorded.
#pragma once

#include <filesystem>
#include <memory>

#include "robots/footage/footage.h"

namespace reorient {

/// Whether the file is a recording of the program.
bool is_recording(const std::filesystem::path& file);

/// Images of the upper camera. The pose is the true pose, if the recording has it. Throws BadFootage.
std::unique_ptr<FootageSource> open_recorded_footage(const std::filesystem::path& file);

}  // namespace reorient
