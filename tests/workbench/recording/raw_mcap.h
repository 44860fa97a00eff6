// SPDX-License-Identifier: MIT
// Writes MCAP files record by record, also those that our own writer does not write.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <lz4frame.h>
#include <zstd.h>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/format.h"

namespace reorient::mcap {

class RawMcap {
 public:
  using Bytes = std::vector<std::byte>;

  void magic() { ByteWriter(bytes_).raw(kMagic.data(), kMagic.size()); }

  void record(Opcode opcode, std::span<const std::byte> content) {
    ByteWriter out(bytes_);
    out(static_cast<std::uint8_t>(opcode), static_cast<std::uint64_t>(content.size()));
    out.raw(content.data(), content.size());
  }

  void header() {
    Bytes content;
    ByteWriter{content}(std::string("ros2"), std::string("a test"));
    record(Opcode::header, content);
  }

  void schema(const Schema& schema) {
    Bytes content;
    ByteWriter{content}(schema.id, schema.name, schema.encoding, schema.text);
    padded_record(Opcode::schema, content);
  }
  void schema(std::uint16_t id, const std::string& name) { schema({id, name, "ros2msg", "# definition"}); }

  void channel(const Channel& channel) {
    Bytes content;
    ByteWriter{content}(channel.id, channel.schema, channel.topic, channel.encoding);
    append_texts(content, channel.metadata);
    padded_record(Opcode::channel, content);
  }
  void channel(std::uint16_t id, std::uint16_t schema, const std::string& topic, const std::string& encoding = "cdr") {
    channel({id, schema, topic, encoding, {}});
  }

  void metadata(const std::string& name, const Texts& texts) {
    Bytes content;
    ByteWriter{content}(name);
    append_texts(content, texts);
    padded_record(Opcode::metadata, content);
  }

  /// Appends bytes of a newer version of the format to the records that follow, which readers ignore.
  void pad() { padding_ = Bytes(7, std::byte{0x5A}); }

  void message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data) {
    Bytes content;
    ByteWriter out(content);
    out(channel, sequence_++, time, time);
    out.raw(data.data(), data.size());
    record(Opcode::message, content);
    first_ = std::min(first_, time);
    last_ = std::max(last_, time);
  }

  /// Writes `records` as a chunk. `compression`: "", "lz4" or "zstd".
  void chunk(const RawMcap& records, const std::string& compression) {
    const Bytes packed = compressed(records.bytes_, compression);
    Bytes content;
    ByteWriter out(content);
    out(records.first_, records.last_, static_cast<std::uint64_t>(records.bytes_.size()), std::uint32_t{0}, compression,
        static_cast<std::uint64_t>(packed.size()));
    out.raw(packed.data(), packed.size());
    padded_record(Opcode::chunk, content);
  }

  /// The description of a chunk in the summary. `where`: its position; `length`: with its head.
  void chunk_index(const RawMcap& records, std::uint64_t where, std::uint64_t length, const std::string& compression) {
    Bytes content;
    ByteWriter{content}(records.first_, records.last_, where, length, std::uint32_t{0}, std::uint64_t{0}, compression,
                        std::uint64_t{0}, static_cast<std::uint64_t>(records.bytes_.size()));
    padded_record(Opcode::chunk_index, content);
  }

  /// Ends the file without a summary.
  void end() { end(RawMcap()); }
  /// Ends it with the records of a summary, without a checksum.
  void end(const RawMcap& summary) {
    Bytes content;
    ByteWriter{content}(std::uint32_t{0});
    record(Opcode::data_end, content);
    const std::uint64_t where = summary.bytes_.empty() ? 0 : bytes_.size();
    bytes_.insert(bytes_.end(), summary.bytes_.begin(), summary.bytes_.end());
    content.clear();
    ByteWriter{content}(where, std::uint64_t{0}, std::uint32_t{0});
    record(Opcode::footer, content);
    magic();
  }

  const Bytes& bytes() const { return bytes_; }

 private:
  static void append_texts(Bytes& content, const Texts& texts) {
    Bytes entries;
    ByteWriter out(entries);
    for (const auto& [key, value] : texts) out(key, value);
    ByteWriter{content}(static_cast<std::uint32_t>(entries.size()));
    content.insert(content.end(), entries.begin(), entries.end());
  }

  void padded_record(Opcode opcode, Bytes content) {
    content.insert(content.end(), padding_.begin(), padding_.end());
    record(opcode, content);
  }

  static Bytes compressed(const Bytes& bytes, const std::string& compression) {
    if (compression == "lz4") {
      Bytes packed(LZ4F_compressFrameBound(bytes.size(), nullptr));
      packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr));
      return packed;
    }
    if (compression == "zstd") {
      Bytes packed(ZSTD_compressBound(bytes.size()));
      packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
      return packed;
    }
    return bytes;
  }

  Bytes bytes_, padding_;
  std::uint32_t sequence_ = 0;
  std::uint64_t first_ = ~std::uint64_t{0}, last_ = 0;  // ns
};

}  // namespace reorient::mcap
