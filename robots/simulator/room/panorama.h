// SPDX-License-Identifier: MIT
// Equirectangular panoramas from files: azimuth across, elevation down, twice as wide as high.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "robots/simulator/room/texture.h"

namespace reorient {

/// Reads a panorama (Radiance .hdr, .png or .jpg, detected by content) into linear light, top row first.
/// Throws std::runtime_error with one line that names the file, the problem and its fix.
LinearImage read_panorama(const std::string& path);

/// The same from memory; `name` is for error messages.
LinearImage decode_panorama(std::span<const std::uint8_t> bytes, const std::string& name);

/// Throws std::runtime_error unless the size is that of an equirectangular panorama that fits into memory.
void check_panorama_size(int width, int height, const std::string& name);

}  // namespace reorient
