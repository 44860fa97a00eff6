#include "workbench/recording/mcap/data.h"

#include <memory>
#include <string>
#include <utility>

#include <zstd.h>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/checksum.h"

namespace reorient::mcap {

ChunkMessages::ChunkMessages(const Source& source, const ChunkPlace& place) : where_(place.where) {
  std::vector<std::byte> stored(static_cast<std::size_t>(place.data_size));
  source.read(place.data, stored);
  if (place.compression.empty()) {
    records_ = std::move(stored);
  } else if (place.compression == "zstd") {
    // Not all at once: how long it is claimed to be, anybody can write.
    const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
    if (!context) throw std::runtime_error("zstd gives no memory to read with");
    ZSTD_inBuffer in{stored.data(), stored.size(), 0};
    constexpr std::size_t kStep = 1u << 20;
    while (in.pos < in.size && records_.size() <= place.size) {
      const std::size_t before = records_.size();
      records_.resize(before + kStep);
      ZSTD_outBuffer out{records_.data() + before, kStep, 0};
      const std::size_t result = ZSTD_decompressStream(context.get(), &out, &in);
      if (ZSTD_isError(result) != 0)
        throw Damage(where_, std::string("a chunk is damaged: ") + ZSTD_getErrorName(result));
      records_.resize(before + out.pos);
      if (result == 0) break;  // the frame is whole
      if (out.pos == 0 && in.pos == in.size) break;
    }
  } else {
    throw Damage(where_, "a chunk is compressed by '" + place.compression + "', which is not read here");
  }
  if (records_.size() != place.size) {
    throw Damage(
        where_, "a chunk holds " + std::to_string(records_.size()) + " bytes instead of " + std::to_string(place.size));
  }
  if (place.crc != 0 && crc_of(0, records_) != place.crc) throw Damage(where_, "a chunk's checksum is another one");
}

bool ChunkMessages::next(Message& message) {
  while (at_ < records_.size()) {
    const std::span<const std::byte> rest = std::span(records_).subspan(at_);
    try {
      ByteReader in(rest);
      std::uint8_t opcode = 0;
      std::uint64_t length = 0;
      in(opcode, length);
      check_bytes(length <= in.left(), "a message is longer than its chunk");
      at_ += kRecordHead + static_cast<std::size_t>(length);
      if (static_cast<Opcode>(opcode) != Opcode::message) continue;
      ByteReader content(rest.subspan(kRecordHead, static_cast<std::size_t>(length)));
      std::uint64_t published = 0;
      content(message.channel, message.sequence, message.time, published);
      message.data = rest.subspan(kRecordHead + static_cast<std::size_t>(length) - content.left(), content.left());
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
  if (crc != 0 && crc != crc_of(0, content)) throw Damage(place.where, "an attachment's checksum is another one");
  content.erase(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(place.data - begin));
  return content;
}

}  // namespace reorient::mcap
