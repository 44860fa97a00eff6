// SPDX-License-Identifier: MIT
// The contents of a complete or damaged MCAP file without the bytes of its messages, read with no more memory than the
// size of the file justifies. It reads the records from the first one and does not need the summary, which is missing
// in files that ended early. With a summary, it also finds what follows a damage.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/mcap/format.h"
#include "workbench/recording/mcap/source.h"

namespace reorient::mcap {

/// Largest size of a chunk in bytes, compressed and uncompressed; larger ones are rejected.
inline constexpr std::uint64_t kLargestChunk = 256u << 20;
/// Largest record of another type that is read as a whole, in bytes: a schema, a channel, metadata.
inline constexpr std::uint64_t kLargestRecord = 16u << 20;

/// The position of a chunk, and the contents of its head.
struct ChunkPlace {
  std::uint64_t where = 0;                     ///< position of its record
  std::uint64_t start_time = 0, end_time = 0;  ///< ns
  std::uint64_t size = 0;                      ///< bytes of its uncompressed messages
  std::uint32_t crc = 0;                       ///< checksum of its messages; 0: unknown
  std::string compression;
  std::uint64_t data = 0, data_size = 0;  ///< position and number of its compressed bytes
  std::uint64_t end = 0;                  ///< position of the end of its record
};

struct AttachmentPlace {
  std::uint64_t where = 0;
  std::string name, media_type;
  std::uint64_t time = 0;                 ///< ns
  std::uint64_t data = 0, data_size = 0;  ///< position and number of its bytes
};

struct Metadata {
  std::string name;
  Texts texts;
};

/// The contents of a file without the messages.
struct Contents {
  std::string library;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<ChunkPlace> chunks;
  std::vector<ChunkPlace> loose;  ///< records with messages outside of chunks, as chunks without compression
  std::vector<AttachmentPlace> attachments;
  std::vector<Metadata> metadata;
  std::optional<Statistics> statistics;  ///< from the summary
  std::optional<Damage> damage;          ///< the first one; more may be unreadable after it
  bool is_complete = false;              ///< the end of the file is present

  /// All chunks and loose messages.
  std::vector<ChunkPlace> places() const;
  const Schema* schema(std::uint16_t id) const;
  const Channel* channel(std::uint16_t id) const;
  const Channel* channel(std::string_view topic) const;
};

/// Whether the file begins with the start mark of MCAP.
bool is_mcap(const Source& source);
/// Throws Damage if it is not an MCAP file.
Contents read_contents(const Source& source);

}  // namespace reorient::mcap
