// SPDX-License-Identifier: MIT
// A frame's record as bytes, and back: for files, for other programs, and for a fingerprint.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/record/digest.h"
#include "engine/record/frame_record.h"

namespace reorient {

/// Appends the record: of the topics that are filled those that are wanted, with the names that they use. `places`:
/// where in `bytes` the first of them begins, and each ends.
void write_record(const FrameRecord& record, std::vector<std::byte>& bytes, Topics wanted = Topics::all(),
                  std::vector<std::size_t>* places = nullptr);

/// A record with memory of its own. Throws BadBytes where the bytes are none, or of another version.
FrameRecord read_record(std::span<const std::byte> bytes);

/// Appends one topic's content alone, whether or not it is filled.
void write_topic(const FrameRecord& record, Topic topic, std::vector<std::byte>& bytes);

/// Adds frame after frame what is the same for the same inputs, on whatever computer, and always filled; of the images
/// the pixels, where the record has them.
class RecordDigest {
 public:
  void add(const FrameRecord& record);
  const Digest& digest() const { return digest_; }

 private:
  Digest digest_;
  std::vector<std::byte> bytes_;
};

}  // namespace reorient
