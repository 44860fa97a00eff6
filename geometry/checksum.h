// SPDX-License-Identifier: MIT
// Detects changes of bytes that were written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace reorient {

/// FNV-1a: http://www.isthe.com/chongo/tech/comp/fnv. A change of a single byte always changes the checksum.
inline std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0xCBF29CE484222325ull;
  for (const std::byte byte : bytes) sum = (sum ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3ull;
  return sum;
}

}  // namespace reorient
