// SPDX-License-Identifier: MIT
// Detects truncated JPEGs, because decoders fill the missing part with gray without an error.
#pragma once

#include <cstddef>
#include <span>

namespace reorient {

/// A JPEG that lacks its end-of-image marker (ITU-T T.81, B.1.1.2). False for other data.
bool is_cut_off_jpeg(std::span<const std::byte> bytes);

}  // namespace reorient
