// SPDX-License-Identifier: MIT
#include "workbench/recording/mcap/writer.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <zstd.h>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/checksum.h"

namespace reorient::mcap {
namespace {

constexpr int kLevel = 1;  // of zstd: higher levels cost time and hardly reduce the size of images

void append(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Writes a map or an array after its length in bytes.
void append_sized(std::vector<std::byte>& out, std::span<const std::byte> entries) {
  ByteWriter{out}(static_cast<std::uint32_t>(entries.size()));
  append(out, entries);
}

void append_texts(std::vector<std::byte>& out, const Texts& texts) {
  std::vector<std::byte> entries;
  ByteWriter writer(entries);
  for (const auto& [key, value] : texts) writer(key, value);
  append_sized(out, entries);
}

void append_record(std::vector<std::byte>& out, Opcode opcode, std::span<const std::byte> content) {
  ByteWriter{out}(opcode, static_cast<std::uint64_t>(content.size()));
  append(out, content);
}

std::vector<std::byte> content_of(const Schema& schema) {
  std::vector<std::byte> content;
  ByteWriter{content}(schema.id, schema.name, schema.encoding, schema.text);
  return content;
}

std::vector<std::byte> content_of(const Channel& channel) {
  std::vector<std::byte> content;
  ByteWriter{content}(channel.id, channel.schema, channel.topic, channel.encoding);
  append_texts(content, channel.metadata);
  return content;
}

std::vector<std::byte> content_of(const Statistics& statistics) {
  std::vector<std::byte> content, counts;
  ByteWriter writer(counts);
  for (const auto& [channel, count] : statistics.messages_of) writer(channel, count);
  ByteWriter{content}(statistics.messages, statistics.schemas, statistics.channels, statistics.attachments,
                      statistics.metadata, statistics.chunks, statistics.first_time, statistics.last_time);
  append_sized(content, counts);
  return content;
}

}  // namespace

Writer::Writer(Sink sink, std::string_view library)
    : sink_(std::move(sink)), compressor_(ZSTD_createCCtx(), ZSTD_freeCCtx) {
  if (!compressor_) throw std::runtime_error("out of memory for compression with zstd");
  put(std::as_bytes(std::span(kMagic)));
  std::vector<std::byte> content;
  ByteWriter{content}(std::string(), std::string(library));
  put_record(Opcode::header, content);
}

Writer::~Writer() = default;

void Writer::put(std::span<const std::byte> bytes) {
  sink_(bytes);
  offset_ += bytes.size();
  crc_ = crc_of(crc_, bytes);
}

void Writer::put_record(Opcode opcode, std::span<const std::byte> content) {
  out_.clear();
  append_record(out_, opcode, content);
  put(out_);
}

std::uint16_t Writer::add_schema(std::string_view name, std::string_view encoding, std::string_view text) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
  const std::uint64_t where = offset_;
  std::vector<std::byte> content = content_of(Schema{id, std::string(name), std::string(encoding), std::string(text)});
  put_record(Opcode::schema, content);
  schemas_.push_back({where, std::move(content)});
  return id;
}

std::uint16_t Writer::add_channel(std::string_view topic, std::string_view encoding, std::uint16_t schema,
                                  const Texts& metadata) {
  const auto id = static_cast<std::uint16_t>(channels_.size());
  const std::uint64_t where = offset_;
  std::vector<std::byte> content = content_of(Channel{id, schema, std::string(topic), std::string(encoding), metadata});
  put_record(Opcode::channel, content);
  channel_records_.push_back({where, std::move(content)});
  channels_.emplace_back();
  return id;
}

void Writer::add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data) {
  ChannelState& state = channels_.at(channel);
  if (chunk_.empty()) {
    chunk_start_ = chunk_end_ = time;
  } else {
    chunk_start_ = std::min(chunk_start_, time);
    chunk_end_ = std::max(chunk_end_, time);
  }
  state.index.push_back({time, chunk_.size()});
  constexpr std::size_t kBeforeData = 2 + 4 + 8 + 8;
  ByteWriter writer(chunk_);
  writer(Opcode::message, static_cast<std::uint64_t>(kBeforeData + data.size()), channel, state.sequence++, time, time);
  writer.raw(data.data(), data.size());
}

void Writer::close_chunk() {
  if (chunk_.empty()) return;
  compressed_.resize(ZSTD_compressBound(chunk_.size()));
  const std::size_t compressed = ZSTD_compressCCtx(compressor_.get(), compressed_.data(), compressed_.size(),
                                                   chunk_.data(), chunk_.size(), kLevel);
  if (ZSTD_isError(compressed) != 0)
    throw std::runtime_error(std::string("compression with zstd failed: ") + ZSTD_getErrorName(compressed));

  const std::string zstd = "zstd";
  out_.clear();
  ByteWriter out(out_);
  const std::size_t before_records = 8 + 8 + 8 + 4 + 4 + zstd.size() + 8;
  out(Opcode::chunk, static_cast<std::uint64_t>(before_records + compressed), chunk_start_, chunk_end_,
      static_cast<std::uint64_t>(chunk_.size()), crc_of(0, chunk_), zstd, static_cast<std::uint64_t>(compressed));
  out.raw(compressed_.data(), compressed);
  const std::uint64_t chunk_length = out_.size();

  ClosedChunk closed{{offset_, {}}, chunk_start_, chunk_end_, {}};
  std::vector<std::byte> places;
  ByteWriter place(places);
  std::vector<std::byte> entries, content;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    std::vector<IndexEntry>& messages = channels_[i].index;
    if (messages.empty()) continue;
    const auto channel = static_cast<std::uint16_t>(i);
    closed.counts.emplace_back(channel, static_cast<std::uint32_t>(messages.size()));
    place(channel, offset_ + out_.size());
    entries.clear();
    content.clear();
    ByteWriter writer(entries);
    for (const IndexEntry& entry : messages) writer(entry.time, entry.offset);
    ByteWriter{content}(channel);
    append_sized(content, entries);
    append_record(out_, Opcode::message_index, content);
    messages.clear();
  }

  ByteWriter writer(closed.content);
  writer(chunk_start_, chunk_end_, offset_, chunk_length);
  append_sized(closed.content, places);
  writer(static_cast<std::uint64_t>(out_.size() - chunk_length), zstd, static_cast<std::uint64_t>(compressed),
         static_cast<std::uint64_t>(chunk_.size()));
  chunk_.clear();
  put(out_);
  for (const auto& [channel, count] : closed.counts) channels_[channel].closed += count;
  chunks_.push_back(std::move(closed));
}

void Writer::add_metadata(std::string_view name, const Texts& texts) {
  std::vector<std::byte> content;
  ByteWriter{content}(std::string(name));
  append_texts(content, texts);
  const std::uint64_t where = offset_;
  put_record(Opcode::metadata, content);
  metadata_.push_back({where, {}});
  ByteWriter{metadata_.back().content}(where, static_cast<std::uint64_t>(kRecordHead + content.size()),
                                       std::string(name));
}

void Writer::add_attachment(std::string_view name, std::string_view media_type, std::uint64_t time,
                            std::span<const std::byte> data) {
  std::vector<std::byte> content;
  ByteWriter writer(content);
  writer(time, time, std::string(name), std::string(media_type), static_cast<std::uint64_t>(data.size()));
  writer.raw(data.data(), data.size());
  writer(crc_of(0, content));
  const std::uint64_t where = offset_;
  put_record(Opcode::attachment, content);
  attachments_.push_back({where, {}});
  ByteWriter{attachments_.back().content}(where, static_cast<std::uint64_t>(kRecordHead + content.size()), time, time,
                                          static_cast<std::uint64_t>(data.size()), std::string(name),
                                          std::string(media_type));
}

Statistics Writer::statistics() const {
  Statistics all;
  all.schemas = static_cast<std::uint16_t>(schemas_.size());
  all.channels = static_cast<std::uint32_t>(channel_records_.size());
  all.attachments = static_cast<std::uint32_t>(attachments_.size());
  all.metadata = static_cast<std::uint32_t>(metadata_.size());
  all.chunks = static_cast<std::uint32_t>(chunks_.size());
  if (!chunks_.empty()) all.first_time = chunks_.front().start;
  for (const ClosedChunk& chunk : chunks_) {
    all.first_time = std::min(all.first_time, chunk.start);
    all.last_time = std::max(all.last_time, chunk.end);
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i].closed == 0) continue;
    all.messages += channels_[i].closed;
    all.messages_of[static_cast<std::uint16_t>(i)] = channels_[i].closed;
  }
  return all;
}

std::vector<std::byte> Writer::end_of_file() const {
  std::vector<std::byte> end, content;
  constexpr std::uint32_t kUnknown = 0;
  ByteWriter{content}(knows_crc_ ? crc_ : kUnknown);
  append_record(end, Opcode::data_end, content);
  const std::size_t before_summary = end.size();

  // Records of the same type are adjacent, so that a reader can go to the ones that it needs.
  std::vector<std::byte> groups;
  const auto append_group = [&](Opcode opcode, const auto& records) {
    const std::uint64_t start = offset_ + end.size();
    for (const Placed& record : records) append_record(end, opcode, record.content);
    const std::uint64_t length = offset_ + end.size() - start;
    if (length == 0) return;
    content.clear();
    ByteWriter{content}(opcode, start, length);
    append_record(groups, Opcode::summary_offset, content);
  };
  append_group(Opcode::schema, schemas_);
  append_group(Opcode::channel, channel_records_);
  append_group(Opcode::statistics, std::vector<Placed>{{0, content_of(statistics())}});
  append_group(Opcode::chunk_index, chunks_);
  append_group(Opcode::attachment_index, attachments_);
  append_group(Opcode::metadata_index, metadata_);
  const std::uint64_t offsets_start = offset_ + end.size();
  append(end, groups);

  // The checksum covers the bytes up to its own position in the footer.
  constexpr std::uint64_t kFooter = 8 + 8 + 4;
  ByteWriter footer(end);
  footer(Opcode::footer, kFooter, offset_ + before_summary, offsets_start);
  footer(crc_of(0, std::span(end).subspan(before_summary)));
  footer.raw(kMagic.data(), kMagic.size());
  return end;
}

void Writer::finish() {
  close_chunk();
  put(end_of_file());
}

bool Writer::make_room() {
  const std::uint64_t needed = end_of_file().size();
  const auto first = std::find_if(chunks_.rbegin(), chunks_.rend(),
                                  [&](const ClosedChunk& chunk) { return offset_ - chunk.offset >= needed; });
  if (first == chunks_.rend()) return false;
  offset_ = first->offset;
  const auto forgotten = std::prev(first.base());
  for (auto chunk = forgotten; chunk != chunks_.end(); ++chunk)
    for (const auto& [channel, count] : chunk->counts) channels_[channel].closed -= count;
  chunks_.erase(forgotten, chunks_.end());
  for (std::vector<Placed>* records : {&schemas_, &channel_records_, &attachments_, &metadata_})
    std::erase_if(*records, [&](const Placed& record) { return record.offset >= offset_; });
  knows_crc_ = false;
  return true;
}

}  // namespace reorient::mcap
