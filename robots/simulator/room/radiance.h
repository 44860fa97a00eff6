// SPDX-License-Identifier: MIT
// Radiance's picture format (.hdr, .pic): red, green and blue with a common exponent, run-length coded or flat.
// Source: Greg Ward, "Real Pixels", Graphics Gems II (1991), and the format description of the Radiance package.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "robots/simulator/room/texture.h"

namespace reorient {

/// Whether the bytes begin with the header of a Radiance picture.
bool looks_like_radiance(std::span<const std::uint8_t> bytes);

/// Decodes a picture into linear light, top row first. `name` is for error messages.
/// Throws std::runtime_error if the picture is incomplete, damaged or of an invalid size.
LinearImage decode_radiance(std::span<const std::uint8_t> bytes, const std::string& name);

}  // namespace reorient
