// SPDX-License-Identifier: MIT
// What is in an MCAP file, a whole one or a damaged one, but for the bytes of its messages: found with no more memory
// than its size justifies. It goes through the records from the first on and needs no summary, which files that ended
// early lack; where there is one, it finds what lies behind a damage.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/mcap/format.h"
#include "workbench/recording/mcap/source.h"

namespace reorient::mcap {

/// Uncompressed; larger ones are refused.
inline constexpr std::uint64_t kLargestChunk = 256u << 20;

/// The position of a chunk, and the contents of its head.
struct ChunkPlace {
  std::uint64_t where = 0;                     ///< of its record
  std::uint64_t start_time = 0, end_time = 0;  ///< ns
  std::uint64_t size = 0;                      ///< bytes of its messages
  std::uint32_t crc = 0;                       ///< of those; 0: unknown
  std::string compression;
  std::uint64_t data = 0, data_size = 0;  ///< where they lie, and how many bytes that are
  std::uint64_t end = 0;                  ///< of its record
  bool after_gap = false;                 ///< what stands before it is damaged: a chunk may have been there
};

struct AttachmentPlace {
  std::uint64_t where = 0;
  std::string name, media_type;
  std::uint64_t time = 0;                 ///< ns
  std::uint64_t data = 0, data_size = 0;  ///< where it lies
};

struct Metadata {
  std::string name;
  Texts texts;
};

/// What is in a file, but for the messages.
struct Contents {
  std::string library;
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<ChunkPlace> chunks;
  std::vector<ChunkPlace> loose;  ///< records with messages outside of chunks, as chunks without compression
  std::vector<AttachmentPlace> attachments;
  std::vector<Metadata> metadata;
  std::optional<Statistics> statistics;  ///< from the summary
  std::optional<Damage> damage;          ///< the first; of what comes after it, what the summary names is listed
  bool is_complete = false;              ///< it has its end

  const Schema* schema(std::uint16_t id) const;
  const Channel* channel(std::uint16_t id) const;
  const Channel* channel(std::string_view topic) const;
};

/// Whether it begins as one.
bool is_mcap(const Source& source);
/// Throws Damage if it is not an MCAP file.
Contents read_contents(const Source& source);

}  // namespace reorient::mcap
