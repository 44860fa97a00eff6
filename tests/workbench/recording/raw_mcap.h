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

  void schema(std::uint16_t id, const std::string& name) {
    Bytes content;
    ByteWriter{content}(id, name, std::string("ros2msg"), std::string("# definition"));
    record(Opcode::schema, content);
  }

  void channel(std::uint16_t id, std::uint16_t schema, const std::string& topic, const std::string& encoding = "cdr") {
    Bytes content;
    ByteWriter{content}(id, schema, topic, encoding, std::uint32_t{0});
    record(Opcode::channel, content);
  }

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
    record(Opcode::chunk, content);
  }

  /// Ends the file without a summary.
  void end() {
    Bytes content;
    ByteWriter{content}(std::uint32_t{0});
    record(Opcode::data_end, content);
    content.clear();
    ByteWriter{content}(std::uint64_t{0}, std::uint64_t{0}, std::uint32_t{0});
    record(Opcode::footer, content);
    magic();
  }

  const Bytes& bytes() const { return bytes_; }

 private:
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

  Bytes bytes_;
  std::uint32_t sequence_ = 0;
  std::uint64_t first_ = ~std::uint64_t{0}, last_ = 0;  // ns
};

}  // namespace reorient::mcap
