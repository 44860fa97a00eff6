// SPDX-License-Identifier: MIT
// The bytes to which the contents of an MCAP file point: messages of chunks, and attachments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/source.h"

namespace reorient::mcap {

struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;  ///< ns
  std::span<const std::byte> data;
};

/// A record of a chunk: a message, a schema, a channel.
struct ChunkRecord {
  Opcode opcode{};
  std::span<const std::byte> content;
};

/// The messages of one chunk, in their order.
class ChunkMessages {
 public:
  /// Throws Damage if the chunk is damaged.
  ChunkMessages(const Source& source, const ChunkPlace& place);

  /// The next message; false after the last one. Throws Damage.
  bool next(Message& message);
  /// The same for records of all types.
  bool next(ChunkRecord& record);

  /// Position of the next record in the uncompressed chunk, bytes.
  std::size_t at() const { return at_; }
  /// Continues at a position that at() returned.
  void go_to(std::size_t at) { at_ = at; }

 private:
  std::uint64_t where_;
  std::vector<std::byte> records_;
  std::size_t at_ = 0;
};

/// Bytes of an attachment. Throws Damage if its checksum is wrong.
std::vector<std::byte> read_attachment(const Source& source, const AttachmentPlace& place);

}  // namespace reorient::mcap
