// SPDX-License-Identifier: MIT
// Writes an MCAP file sequentially: chunks compressed with zstd, an index of each, and a summary at the end. A file
// that ends early lacks only the summary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workbench/recording/mcap/format.h"

struct ZSTD_CCtx_s;

namespace reorient::mcap {

class Writer {
 public:
  /// Accepts bytes in their order, all of them or none. Its exceptions reach the caller of the writer. The rejected
  /// bytes are omitted, and the file can still be finished.
  using Sink = std::function<void(std::span<const std::byte>)>;

  /// `library`: name of the writing program, for information.
  Writer(Sink sink, std::string_view library);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // To be called before their first message.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view text);
  std::uint16_t add_channel(std::string_view topic, std::string_view encoding, std::uint16_t schema,
                            const Texts& metadata = {});

  /// Adds a message to the open chunk. `time`: ns, of its content.
  void add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data);
  /// Bytes of messages that were not yet passed to the sink.
  std::size_t waiting() const { return chunk_.size(); }
  /// Passes them to the sink in one call.
  void close_chunk();

  void add_metadata(std::string_view name, const Texts& texts);
  void add_attachment(std::string_view name, std::string_view media_type, std::uint64_t time,
                      std::span<const std::byte> data);

  /// Closes the chunk and writes the summary in one call. Nothing may be added afterwards. If the sink has no space for
  /// it, the call can be repeated.
  void finish();
  /// Drops as many of the last chunks as the summary needs space, and everything after them. The file then ends at
  /// size(), and only finish() may follow. Returns false without a change if the chunks are smaller than the summary.
  bool make_room();

  // Data that was passed to the sink, without dropped data.
  std::uint64_t size() const { return offset_; }  ///< bytes
  std::uint64_t messages_of(std::uint16_t channel) const { return channels_.at(channel).closed; }

 private:
  struct IndexEntry {
    std::uint64_t time;
    std::uint64_t offset;
  };
  struct ChannelState {
    std::uint32_t sequence = 0;
    std::uint64_t closed = 0;       // messages in closed chunks
    std::vector<IndexEntry> index;  // of the open chunk
  };
  struct Placed {
    std::uint64_t offset;            // position of the record in the file
    std::vector<std::byte> content;  // its description in the summary
  };
  struct ClosedChunk : Placed {
    std::uint64_t start, end;                                     // ns
    std::vector<std::pair<std::uint16_t, std::uint32_t>> counts;  // messages by channel
  };

  void put(std::span<const std::byte> bytes);
  void put_record(Opcode opcode, std::span<const std::byte> content);
  Statistics statistics() const;
  std::vector<std::byte> end_of_file() const;

  Sink sink_;
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> compressor_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;  // of all bytes that were passed to the sink
  bool knows_crc_ = true;  // false after chunks were dropped

  std::vector<ChannelState> channels_;
  std::vector<std::byte> chunk_, compressed_, out_;
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;  // ns
  std::vector<Placed> schemas_, channel_records_, attachments_, metadata_;
  std::vector<ClosedChunk> chunks_;
};

}  // namespace reorient::mcap
