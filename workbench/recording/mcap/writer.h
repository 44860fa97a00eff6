// Writes an MCAP file from its first byte to its last, never looking back: chunks with zstd, an index of each, and at
// the end a summary. A file that ends early lacks the summary alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/mcap/format.h"

struct ZSTD_CCtx_s;

namespace reorient::mcap {

class Writer {
 public:
  /// Takes bytes in their order, all of them or none. What it throws reaches whoever called the writer; what was to be
  /// written then is left out, and the file may still be finished.
  using Sink = std::function<void(std::span<const std::byte>)>;

  /// `library`: the program that writes, for people.
  Writer(Sink sink, std::string_view library);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // Before their first message.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view text);
  std::uint16_t add_channel(std::string_view topic, std::string_view encoding, std::uint16_t schema,
                            const Texts& metadata = {});

  /// Into the chunk that is open. `time`: ns, of what it tells.
  void add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data);
  /// Bytes of messages that the sink has not got yet.
  std::size_t waiting() const { return chunk_.size(); }
  /// Hands them to the sink, at once.
  void close_chunk();

  void add_metadata(std::string_view name, const Texts& texts);
  void add_attachment(std::string_view name, std::string_view media_type, std::uint64_t time,
                      std::span<const std::byte> data);

  /// Closes the chunk, and writes the summary. Nothing may be added any more.
  void finish();

  const Statistics& statistics() const { return statistics_; }
  std::uint64_t size() const { return offset_; }  ///< bytes that the sink has got

 private:
  struct IndexEntry {
    std::uint64_t time;
    std::uint64_t offset;
  };
  struct ChannelState {
    Channel channel;
    std::uint32_t sequence = 0;
    std::vector<IndexEntry> index;  // of the open chunk
  };
  struct Group {
    Opcode opcode;
    std::uint64_t start, length;
  };

  void put(std::span<const std::byte> bytes);
  void put_record(Opcode opcode, std::span<const std::byte> content);
  void put_summary_group(Opcode opcode, const std::vector<std::vector<std::byte>>& contents);

  Sink sink_;
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> compressor_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;  // of all that the sink has got, or of the summary

  std::vector<Schema> schemas_;
  std::vector<ChannelState> channels_;
  std::vector<std::byte> chunk_, compressed_, out_;
  std::uint64_t chunk_start_ = 0, chunk_end_ = 0;  // ns
  std::vector<std::vector<std::byte>> chunk_indexes_, attachment_indexes_, metadata_indexes_;
  std::vector<Group> groups_;
  Statistics statistics_;
};

}  // namespace reorient::mcap
