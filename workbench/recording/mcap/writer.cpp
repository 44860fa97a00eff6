#include "workbench/recording/mcap/writer.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <zstd.h>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/checksum.h"

namespace reorient::mcap {
namespace {

constexpr int kLevel = 1;  // of zstd: images hardly shrink further, and a robot has better to do

void append(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// What a map or an array is behind its length in bytes.
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
  if (!compressor_) throw std::runtime_error("zstd gives no memory to compress with");
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
  schemas_.push_back({id, std::string(name), std::string(encoding), std::string(text)});
  put_record(Opcode::schema, content_of(schemas_.back()));
  ++statistics_.schemas;
  return id;
}

std::uint16_t Writer::add_channel(std::string_view topic, std::string_view encoding, std::uint16_t schema,
                                  const Texts& metadata) {
  const auto id = static_cast<std::uint16_t>(channels_.size());
  channels_.push_back({{id, schema, std::string(topic), std::string(encoding), metadata}, 0, {}});
  put_record(Opcode::channel, content_of(channels_.back().channel));
  ++statistics_.channels;
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
    throw std::runtime_error(std::string("zstd does not compress: ") + ZSTD_getErrorName(compressed));

  static const std::string kZstd = "zstd";
  out_.clear();
  ByteWriter out(out_);
  const std::size_t before_records = 8 + 8 + 8 + 4 + 4 + kZstd.size() + 8;
  out(Opcode::chunk, static_cast<std::uint64_t>(before_records + compressed), chunk_start_, chunk_end_,
      static_cast<std::uint64_t>(chunk_.size()), crc_of(0, chunk_), kZstd, static_cast<std::uint64_t>(compressed));
  out.raw(compressed_.data(), compressed);
  const std::uint64_t chunk_length = out_.size();

  Statistics after = statistics_;  // once it is written
  ++after.chunks;
  after.first_time = after.messages == 0 ? chunk_start_ : std::min(after.first_time, chunk_start_);
  after.last_time = std::max(after.last_time, chunk_end_);
  std::vector<std::byte> places;
  ByteWriter place(places);
  std::vector<std::byte> entries, content;
  for (ChannelState& state : channels_) {
    if (state.index.empty()) continue;
    after.messages += state.index.size();
    after.messages_of[state.channel.id] += state.index.size();
    place(state.channel.id, offset_ + out_.size());
    entries.clear();
    content.clear();
    ByteWriter writer(entries);
    for (const IndexEntry& entry : state.index) writer(entry.time, entry.offset);
    ByteWriter{content}(state.channel.id);
    append_sized(content, entries);
    append_record(out_, Opcode::message_index, content);
    state.index.clear();
  }

  std::vector<std::byte> index;
  ByteWriter writer(index);
  writer(chunk_start_, chunk_end_, offset_, chunk_length);
  append_sized(index, places);
  writer(static_cast<std::uint64_t>(out_.size() - chunk_length), kZstd, static_cast<std::uint64_t>(compressed),
         static_cast<std::uint64_t>(chunk_.size()));
  chunk_.clear();
  put(out_);
  statistics_ = std::move(after);
  chunk_indexes_.push_back(std::move(index));
}

void Writer::add_metadata(std::string_view name, const Texts& texts) {
  std::vector<std::byte> content;
  ByteWriter{content}(std::string(name));
  append_texts(content, texts);
  const std::uint64_t where = offset_;
  put_record(Opcode::metadata, content);
  ByteWriter{metadata_indexes_.emplace_back()}(where, static_cast<std::uint64_t>(kRecordHead + content.size()),
                                               std::string(name));
  ++statistics_.metadata;
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
  ByteWriter{attachment_indexes_.emplace_back()}(where, static_cast<std::uint64_t>(kRecordHead + content.size()), time,
                                                 time, static_cast<std::uint64_t>(data.size()), std::string(name),
                                                 std::string(media_type));
  ++statistics_.attachments;
}

/// Records of one kind lie together, so that a reader can go to those that it wants.
void Writer::put_summary_group(Opcode opcode, const std::vector<std::vector<std::byte>>& contents) {
  const std::uint64_t start = offset_;
  for (const std::vector<std::byte>& content : contents) put_record(opcode, content);
  if (offset_ > start) groups_.push_back({opcode, start, offset_ - start});
}

void Writer::finish() {
  close_chunk();
  std::vector<std::byte> content;
  ByteWriter{content}(crc_);
  put_record(Opcode::data_end, content);

  const std::uint64_t summary_start = offset_;
  crc_ = 0;
  std::vector<std::vector<std::byte>> schemas, channels;
  for (const Schema& schema : schemas_) schemas.push_back(content_of(schema));
  for (const ChannelState& state : channels_) channels.push_back(content_of(state.channel));
  put_summary_group(Opcode::schema, schemas);
  put_summary_group(Opcode::channel, channels);
  put_summary_group(Opcode::statistics, {content_of(statistics_)});
  put_summary_group(Opcode::chunk_index, chunk_indexes_);
  put_summary_group(Opcode::attachment_index, attachment_indexes_);
  put_summary_group(Opcode::metadata_index, metadata_indexes_);
  const std::uint64_t offsets_start = offset_;
  for (const Group& group : groups_) {
    content.clear();
    ByteWriter{content}(group.opcode, group.start, group.length);
    put_record(Opcode::summary_offset, content);
  }

  // The checksum ends in the middle of the footer, before itself.
  constexpr std::uint64_t kFooter = 8 + 8 + 4;
  out_.clear();
  ByteWriter footer(out_);
  footer(Opcode::footer, kFooter, summary_start, offsets_start);
  footer(crc_of(crc_, out_));
  footer.raw(kMagic.data(), kMagic.size());
  put(out_);
}

}  // namespace reorient::mcap
