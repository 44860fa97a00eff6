// Two truths in one byte: a rare one beside a common one leaves the bytes of a record without it, and so its digest, as
// they were.
#pragma once

#include <cstdint>

#include "geometry/bytes.h"

namespace reorient {

/// Made where values are visited; holds nothing itself.
struct SharedByte {
  bool& common;
  bool& rare;

  /// Throws BadBytes.
  template <typename Archive>
  void archive(Archive& archive) {
    auto byte = static_cast<std::uint8_t>((common ? 1u : 0u) | (rare ? 2u : 0u));
    archive(byte);
    if constexpr (Archive::kReads) {
      check_bytes(byte < 4, "two truths are none");
      common = (byte & 1u) != 0;
      rare = (byte & 2u) != 0;
    }
  }
};

}  // namespace reorient
