// SPDX-License-Identifier: MIT
// The checksum of MCAP's records: CRC-32 as in zlib.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <zlib.h>

namespace reorient::mcap {

/// Continues the checksum `so_far` with these bytes; 0: starts a checksum.
inline std::uint32_t crc_of(std::uint32_t so_far, std::span<const std::byte> bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(so_far, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace reorient::mcap
