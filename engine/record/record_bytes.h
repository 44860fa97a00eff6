// SPDX-License-Identifier: MIT
// A frame's record as bytes, and back: for files, for other programs, and for a digest.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/record/digest.h"
#include "engine/record/frame_record.h"

namespace reorient {

/// Appends the record: of the filled topics those in `requested`, with the names that they use. `places`:
/// the offsets in `bytes` at which the first topic begins and each topic ends.
void write_record(const FrameRecord& record, std::vector<std::byte>& bytes, Topics requested = Topics::all(),
                  std::vector<std::size_t>* places = nullptr);

/// A record with its own memory. Throws BadBytes if the bytes are invalid or of another version.
FrameRecord read_record(std::span<const std::byte> bytes);

/// Appends one topic's content alone, whether or not it is filled.
void write_topic(const FrameRecord& record, Topic topic, std::vector<std::byte>& bytes);

/// Adds, frame by frame, the topics that are always filled and the same for the same inputs on any computer; of the
/// images the pixels if the record has them.
class RecordDigest {
 public:
  void add(const FrameRecord& record);
  const Digest& digest() const { return digest_; }

 private:
  Digest digest_;
  std::vector<std::byte> bytes_;
};

}  // namespace reorient
