// SPDX-License-Identifier: MIT
// A recording of ours as footage: what a robot, or the simulator, saw before.
#pragma once

#include <filesystem>
#include <memory>

#include "robots/footage/footage.h"

namespace reorient {

/// Whether it is one; of no other file it is said.
bool is_recording(const std::filesystem::path& file);

/// Of the upper camera. The pose is the truth, where the recording knows it. Throws BadFootage.
std::unique_ptr<FootageSource> open_recorded_footage(const std::filesystem::path& file);

}  // namespace reorient
