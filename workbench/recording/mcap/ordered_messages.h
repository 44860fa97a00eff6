// SPDX-License-Identifier: MIT
// The messages of some topics of a file, in the order of their log times, however the file stores them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <vector>

#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/data.h"
#include "workbench/recording/mcap/source.h"

namespace reorient::mcap {

class OrderedMessages {
 public:
  static constexpr std::uint64_t kMostMemory = 512u << 20;  // bytes of chunks that are open at once

  /// Reads each chunk of `places` when its first message is due. `source` must outlive this.
  OrderedMessages(const Source& source, std::vector<ChunkPlace> places, std::set<std::uint16_t> channels,
                  std::uint64_t most_memory = kMostMemory);

  /// The next message, valid until the next call; false after the last one. Messages with the same time come in the
  /// order of the file. Throws Damage, also for chunks that overlap in time and need more than `most_memory` together;
  /// the next call continues with what is left.
  bool next(Message& message);
  /// Position of the chunk, or of the group of messages, that contains the last message.
  std::uint64_t where() const { return current_->where; }

 private:
  /// A message of a chunk, small because a chunk may contain millions.
  struct Indexed {
    std::uint64_t time;
    std::uint32_t at;  // position in the chunk, which has at most kLargestChunk bytes
  };
  struct OpenChunk {
    OpenChunk(const Source& source, const ChunkPlace& place) : records(source, place), where(place.where) {}

    ChunkMessages records;
    std::uint64_t where;
    std::uint64_t size = 0;         // bytes
    std::vector<Indexed> messages;  // by time
    std::size_t at = 0;
    std::optional<Damage> damage;  // after the messages
    std::uint64_t time() const { return messages[at].time; }
  };
  struct Later {
    bool operator()(const std::unique_ptr<OpenChunk>& a, const std::unique_ptr<OpenChunk>& b) const {
      return a->time() != b->time() ? a->time() > b->time() : a->where > b->where;
    }
  };

  bool must_open_next() const;
  void open_next();

  const Source& source_;
  std::vector<ChunkPlace> places_;  // by start time
  std::size_t next_place_ = 0;
  std::set<std::uint16_t> channels_;
  std::uint64_t most_memory_, memory_ = 0;
  std::vector<std::unique_ptr<OpenChunk>> open_;  // a heap with the earliest message first
  std::unique_ptr<OpenChunk> current_;            // chunk of the last returned message
};

}  // namespace reorient::mcap
