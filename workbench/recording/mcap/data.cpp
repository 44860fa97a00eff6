// SPDX-License-Identifier: MIT
#include "workbench/recording/mcap/data.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <lz4frame.h>
#include <zstd.h>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/checksum.h"

namespace reorient::mcap {

namespace {

constexpr std::size_t kStep = 1u << 20;  // bytes; memory grows in steps because the stated size of a chunk may be wrong

std::vector<std::byte> unpack_zstd(std::span<const std::byte> stored, const ChunkPlace& place) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::runtime_error("out of memory for decompression with zstd");
  std::vector<std::byte> records;
  ZSTD_inBuffer in{stored.data(), stored.size(), 0};
  while (in.pos < in.size && records.size() <= place.size) {
    const std::size_t before = records.size();
    records.resize(before + kStep);
    ZSTD_outBuffer out{records.data() + before, kStep, 0};
    const std::size_t result = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(result) != 0)
      throw Damage(place.where, std::string("a chunk is damaged: ") + ZSTD_getErrorName(result));
    records.resize(before + out.pos);
    if (result == 0) break;  // the frame is complete
    if (out.pos == 0 && in.pos == in.size) break;
  }
  return records;
}

std::vector<std::byte> unpack_lz4(std::span<const std::byte> stored, const ChunkPlace& place) {
  LZ4F_dctx* made = nullptr;
  const LZ4F_errorCode_t failure = LZ4F_createDecompressionContext(&made, LZ4F_VERSION);
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(made, LZ4F_freeDecompressionContext);
  if (LZ4F_isError(failure) != 0) throw std::runtime_error("out of memory for decompression with lz4");
  std::vector<std::byte> records;
  while (records.size() <= place.size) {
    const std::size_t before = records.size();
    records.resize(before + kStep);
    std::size_t written = kStep, consumed = stored.size();
    const std::size_t result =
        LZ4F_decompress(context.get(), records.data() + before, &written, stored.data(), &consumed, nullptr);
    if (LZ4F_isError(result) != 0)
      throw Damage(place.where, std::string("a chunk is damaged: ") + LZ4F_getErrorName(result));
    records.resize(before + written);
    stored = stored.subspan(consumed);
    if (result == 0 || (written == 0 && consumed == 0)) break;  // the frame is complete, or truncated
  }
  return records;
}

}  // namespace

ChunkMessages::ChunkMessages(const Source& source, const ChunkPlace& place) : where_(place.where) {
  std::vector<std::byte> stored(static_cast<std::size_t>(place.data_size));
  source.read(place.data, stored);
  if (place.compression.empty()) {
    records_ = std::move(stored);
  } else if (place.compression == "zstd") {
    records_ = unpack_zstd(stored, place);
  } else if (place.compression == "lz4") {
    records_ = unpack_lz4(stored, place);
  } else {
    throw Damage(where_, "a chunk has an unknown compression (expected lz4, zstd or none)");
  }
  if (records_.size() != place.size) {
    throw Damage(where_, "expected a chunk of " + std::to_string(place.size) + " bytes, found " +
                             std::to_string(records_.size()));
  }
  if (place.crc != 0 && crc_of(0, records_) != place.crc) throw Damage(where_, "a chunk's checksum is wrong");
}

bool ChunkMessages::next(ChunkRecord& record) {
  if (at_ == records_.size()) return false;
  const std::span<const std::byte> rest = std::span(records_).subspan(at_);
  try {
    ByteReader in(rest);
    std::uint8_t opcode = 0;
    std::uint64_t length = 0;
    in(opcode, length);
    check_bytes(length <= in.left(), "a message is longer than its chunk");
    record.opcode = static_cast<Opcode>(opcode);
    record.content = rest.subspan(kRecordHead, static_cast<std::size_t>(length));
    at_ += kRecordHead + static_cast<std::size_t>(length);
    return true;
  } catch (const BadBytes& bad) {
    at_ = records_.size();
    throw Damage(where_, bad.what());
  }
}

bool ChunkMessages::next(Message& message) {
  for (ChunkRecord record; next(record);) {
    if (record.opcode != Opcode::message) continue;
    try {
      ByteReader content(record.content);
      std::uint64_t published = 0;
      content(message.channel, message.sequence, message.time, published);
      message.data = record.content.last(content.left());
      return true;
    } catch (const BadBytes& bad) {
      at_ = records_.size();
      throw Damage(where_, bad.what());
    }
  }
  return false;
}

std::vector<std::byte> read_attachment(const Source& source, const AttachmentPlace& place) {
  constexpr std::uint64_t kCrc = 4;
  const std::uint64_t begin = place.where + kRecordHead;
  std::vector<std::byte> content(static_cast<std::size_t>(place.data + place.data_size + kCrc - begin));
  source.read(begin, content);
  std::uint32_t crc = 0;
  ByteReader{std::span(content).last(kCrc)}(crc);
  content.resize(content.size() - kCrc);
  if (crc != 0 && crc != crc_of(0, content)) throw Damage(place.where, "an attachment's checksum is wrong");
  content.erase(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(place.data - begin));
  return content;
}

}  // namespace reorient::mcap
