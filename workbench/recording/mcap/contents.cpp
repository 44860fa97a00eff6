// SPDX-License-Identifier: MIT
#include "workbench/recording/mcap/contents.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/checksum.h"
#include "workbench/recording/mcap/records.h"

namespace reorient::mcap {
namespace {

struct RecordHead {
  std::uint64_t where = 0;
  std::uint8_t opcode = 0;
  std::uint64_t length = 0;
  std::uint64_t content() const { return where + kRecordHead; }
  std::uint64_t end() const { return content() + length; }
};

/// Iterates over the records of an untrusted source.
class Walk {
 public:
  explicit Walk(const Source& source) : source_(source) {}

  /// Reads records from `where` while `read` returns true. Returns the end of the last one. Throws Damage, also for
  /// invalid contents of a record.
  template <typename Read>
  std::uint64_t each_from(std::uint64_t where, Read read) const {
    while (where < source_.size()) {
      const RecordHead head = head_at(where);
      where = head.end();
      try {
        if (!read(head)) return where;
      } catch (const BadBytes& bad) {
        throw Damage(head.where, bad.what());
      }
    }
    throw Damage(where, "the end of the file is missing");
  }

  std::uint64_t size() const { return source_.size(); }

  RecordHead head_at(std::uint64_t where) const {
    const std::uint64_t left = source_.size() - where;
    if (left < kRecordHead) throw Damage(where, "the file ends within the head of a record");
    std::array<std::byte, kRecordHead> bytes{};
    source_.read(where, bytes);
    RecordHead head;
    head.where = where;
    ByteReader{bytes}(head.opcode, head.length);
    // Zeros are lost blocks or the hole of a sparse file, and would be many billions of empty records.
    if (head.opcode == 0) throw Damage(where, "expected a record, found a byte of value 0");
    if (head.length > left - kRecordHead) {
      throw Damage(where, "expected a record of at most " + std::to_string(left - kRecordHead) + " bytes, found " +
                              std::to_string(head.length));
    }
    return head;
  }

  /// The whole content of the record. Throws BadBytes for a record that is too large.
  std::vector<std::byte> content_of(const RecordHead& head) const {
    if (head.length > kLargestRecord) {
      throw BadBytes("expected a record of at most " + std::to_string(kLargestRecord) + " bytes, found " +
                     std::to_string(head.length));
    }
    return beginning_of(head, head.length);
  }

  /// The first bytes of the record's content, at most `most`.
  std::vector<std::byte> beginning_of(const RecordHead& head, std::uint64_t most) const {
    std::vector<std::byte> content(static_cast<std::size_t>(std::min(head.length, most)));
    source_.read(head.content(), content);
    return content;
  }

 private:
  const Source& source_;
};

Metadata read_metadata(ByteReader in) {
  Metadata metadata;
  in(metadata.name);
  metadata.texts = read_texts(in);
  return metadata;
}

Statistics read_statistics(ByteReader in) {
  Statistics statistics;
  in(statistics.messages, statistics.schemas, statistics.channels, statistics.attachments, statistics.metadata,
     statistics.chunks, statistics.first_time, statistics.last_time);
  read_sized(in, [&](ByteReader& entries) {
    std::uint16_t channel = 0;
    std::uint64_t count = 0;
    entries(channel, count);
    statistics.messages_of[channel] = count;
  });
  return statistics;
}

/// Reads only the head of a chunk, not the bytes of its messages.
ChunkPlace read_chunk_head(const RecordHead& head, std::span<const std::byte> begin) {
  ByteReader in(begin);
  ChunkPlace place;
  place.where = head.where;
  place.end = head.end();
  in(place.start_time, place.end_time, place.size, place.crc, place.compression, place.data_size);
  const std::uint64_t before_data = begin.size() - in.left();
  place.data = head.content() + before_data;
  check_bytes(place.data_size <= head.length - before_data, "a chunk's messages are longer than its record");
  if (const std::uint64_t size = std::max(place.size, place.data_size); size > kLargestChunk) {
    throw BadBytes("expected a chunk of at most " + std::to_string(kLargestChunk) + " bytes, found " +
                   std::to_string(size));
  }
  return place;
}

AttachmentPlace read_attachment_head(const RecordHead& head, std::span<const std::byte> begin) {
  ByteReader in(begin);
  AttachmentPlace place;
  place.where = head.where;
  std::uint64_t created = 0;
  in(place.time, created, place.name, place.media_type, place.data_size);
  const std::uint64_t before_data = begin.size() - in.left();
  place.data = head.content() + before_data;
  constexpr std::uint64_t kCrc = 4;
  check_bytes(head.length >= before_data + kCrc && place.data_size == head.length - before_data - kCrc,
              "the length of an attachment differs from its record");
  return place;
}

/// Groups messages outside of chunks, so that a large number of them needs no more memory. Ignores records that are too
/// short for a message.
void add_loose_message(const Walk& walk, const RecordHead& head, std::vector<ChunkPlace>& loose) {
  constexpr std::uint64_t kBeforeData = 2 + 4 + 8 + 8, kLargestGroup = 4u << 20;
  if (head.length < kBeforeData || head.end() - head.where > kLargestChunk) return;
  const std::vector<std::byte> content = walk.beginning_of(head, kBeforeData);
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;
  ByteReader{content}(channel, sequence, time);
  if (loose.empty() || head.end() - loose.back().where > kLargestGroup) {
    ChunkPlace group;
    group.where = group.data = head.where;
    group.start_time = group.end_time = time;
    loose.push_back(group);
  }
  ChunkPlace& group = loose.back();
  group.start_time = std::min(group.start_time, time);
  group.end_time = std::max(group.end_time, time);
  group.end = head.end();
  group.size = group.data_size = group.end - group.where;
}

constexpr std::uint64_t kMostBeforeData = 4096;  // bytes of the head of a chunk or an attachment, including names

/// Records that were found, with their position in bytes. A writer may repeat records.
struct Known {
  std::map<std::uint16_t, std::uint64_t> schemas, channels;  // by number
  std::map<std::uint64_t, std::size_t> metadata;             // by position, the index in the list
  std::uint64_t hidden = 0;                                  // bytes of metadata that only the summary lists
};

template <typename Record>
void add_new(std::vector<Record>& all, std::map<std::uint16_t, std::uint64_t>& known, Record record,
             std::uint64_t where) {
  constexpr std::size_t kMost = 4096;  // limited because the lists are searched many times
  if (!known.emplace(record.id, where).second) return;
  check_bytes(all.size() < kMost, "expected at most 4096 topics or schemas, found more");
  all.push_back(std::move(record));
}

/// Returns false at the end of the data.
bool read_record(const Walk& walk, const RecordHead& head, Known& known, Contents& contents) {
  switch (static_cast<Opcode>(head.opcode)) {
    case Opcode::header: {
      const std::vector<std::byte> content = walk.content_of(head);
      std::string profile;
      ByteReader in(content);
      in(profile, contents.library);
      return true;
    }
    case Opcode::schema:
      add_new(contents.schemas, known.schemas, read_schema(ByteReader(walk.content_of(head))), head.where);
      return true;
    case Opcode::channel:
      add_new(contents.channels, known.channels, read_channel(ByteReader(walk.content_of(head))), head.where);
      return true;
    case Opcode::metadata:
      contents.metadata.push_back(read_metadata(ByteReader(walk.content_of(head))));
      known.metadata.emplace(head.where, contents.metadata.size() - 1);
      return true;
    case Opcode::message:
      add_loose_message(walk, head, contents.loose);
      return true;
    case Opcode::chunk:
      contents.chunks.push_back(read_chunk_head(head, walk.beginning_of(head, kMostBeforeData)));
      return true;
    case Opcode::attachment:
      contents.attachments.push_back(read_attachment_head(head, walk.beginning_of(head, kMostBeforeData)));
      return true;
    case Opcode::data_end:
      return false;
    default:  // an index, or a record of a newer version of MCAP
      return true;
  }
}

void report(const Damage& damage, Contents& contents) {
  if (!contents.damage) contents.damage = damage;
}

/// The position of a chunk, from a record of the summary.
std::uint64_t read_chunk_index(ByteReader in) {
  std::uint64_t start_time = 0, end_time = 0, where = 0;
  in(start_time, end_time, where);
  return where;
}

/// Reads a record that the summary lists but that was not found in the data because of a damage.
void read_hidden(const Walk& walk, std::uint64_t where, Opcode opcode, Known& known, Contents& contents) {
  try {
    walk.each_from(where, [&](const RecordHead& head) {
      if (static_cast<Opcode>(head.opcode) != opcode) throw Damage(where, "a record that the summary lists is missing");
      // Together they fit into the file. A summary that lists the same bytes many times would take quadratic time.
      if (opcode == Opcode::metadata && (known.hidden += head.length) > walk.size())
        throw Damage(where, "the summary lists more metadata than the file contains");
      read_record(walk, head, known, contents);
      return false;
    });
  } catch (const Damage& damage) {
    report(damage, contents);
  }
}

/// Takes schemas and channels that the summary repeats from there, because it has a checksum. Records of the data that
/// differ are damaged.
template <typename Record>
void prefer_summary(const std::vector<Record>& in_data, const std::map<std::uint16_t, std::uint64_t>& places,
                    std::vector<Record>& in_summary, Contents& contents) {
  if (in_summary.empty()) in_summary = in_data;  // the writer of the file does not repeat them
  for (const Record& record : in_data) {
    if (std::find(in_summary.begin(), in_summary.end(), record) == in_summary.end())
      report(Damage(places.at(record.id), "a topic or schema is not described in the summary"), contents);
  }
}

/// The summary contains the position and the name of metadata.
void take_metadata(const Walk& walk, ByteReader in, bool is_sound, Known& known, Contents& contents) {
  std::uint64_t where = 0, length = 0;
  std::string name;
  in(where, length, name);
  if (!known.metadata.contains(where)) read_hidden(walk, where, Opcode::metadata, known, contents);
  const auto found = known.metadata.find(where);
  if (!is_sound || found == known.metadata.end() || contents.metadata[found->second].name == name) return;
  report(Damage(where, "the name of metadata differs from the summary"), contents);
  contents.metadata[found->second].name = name;
}

/// Checks the bytes after the last record.
void read_end(const Source& source, std::uint64_t where) {
  std::array<std::byte, kMagic.size()> magic{};
  if (source.size() - where < magic.size()) throw Damage(where, "the file ends within the end mark of an MCAP file");
  source.read(where, magic);
  if (std::memcmp(magic.data(), kMagic.data(), kMagic.size()) != 0)
    throw Damage(where, "the end mark of an MCAP file is missing");
}

constexpr std::uint64_t kFooter = kRecordHead + 2 * sizeof(std::uint64_t) + sizeof(std::uint32_t);

/// Whether the checksum of the summary, at the end of the file, is present and correct.
bool is_sound(const Source& source, std::uint64_t summary) {
  std::uint32_t crc = 0;
  const std::uint64_t end = source.size() - kMagic.size() - sizeof(crc);
  if (source.size() < summary + kFooter + kMagic.size() || end - summary > kLargestChunk) return false;
  std::vector<std::byte> bytes(static_cast<std::size_t>(end - summary) + sizeof(crc));
  source.read(summary, bytes);
  ByteReader{std::span(bytes).last(sizeof(crc))}(crc);
  return crc != 0 && crc == crc_of(0, std::span(bytes).first(bytes.size() - sizeof(crc)));
}

/// Reads the summary after the data. It lists the contents of the data again, so what follows a damage is found, too.
void read_summary(const Walk& walk, const Source& source, std::uint64_t from, Known& known, Contents& contents) {
  const bool sound = is_sound(source, from);
  const Known in_data = known;
  const std::vector<Schema> schemas = contents.schemas;
  const std::vector<Channel> channels = contents.channels;
  if (sound) {
    known.schemas.clear();
    known.channels.clear();
    contents.schemas.clear();
    contents.channels.clear();
  }
  std::set<std::uint64_t> listed;
  for (const ChunkPlace& place : contents.chunks) listed.insert(place.where);
  const std::uint64_t end = walk.each_from(from, [&](const RecordHead& head) {
    switch (static_cast<Opcode>(head.opcode)) {
      case Opcode::schema:
      case Opcode::channel:
        return read_record(walk, head, known, contents);
      case Opcode::statistics:
        contents.statistics = read_statistics(ByteReader(walk.content_of(head)));
        return true;
      case Opcode::chunk_index: {
        const std::uint64_t chunk = read_chunk_index(ByteReader(walk.content_of(head)));
        check_bytes(chunk < from, "the summary lists a chunk after the end of the data");
        if (listed.insert(chunk).second) read_hidden(walk, chunk, Opcode::chunk, known, contents);
        return true;
      }
      case Opcode::metadata_index:
        take_metadata(walk, ByteReader(walk.content_of(head)), sound, known, contents);
        return true;
      case Opcode::footer:
        return false;
      default:
        return true;
    }
  });
  if (sound) {
    prefer_summary(schemas, in_data.schemas, contents.schemas, contents);
    prefer_summary(channels, in_data.channels, contents.channels, contents);
  }
  read_end(source, end);
  contents.is_complete = true;
}

/// Position of the summary, from the last record; 0: no summary.
std::uint64_t summary_of(const Walk& walk, const Source& source) {
  if (source.size() < kFooter + 2 * kMagic.size()) return 0;
  const std::uint64_t footer = source.size() - kMagic.size() - kFooter;
  const RecordHead head = walk.head_at(footer);
  if (static_cast<Opcode>(head.opcode) != Opcode::footer || head.end() != source.size() - kMagic.size()) return 0;
  std::uint64_t where = 0;
  ByteReader{walk.content_of(head)}(where);
  return where < footer ? where : 0;
}

/// Sorts the chunks by position and removes overlapping ones, because a byte belongs to only one chunk.
void sort_chunks(std::vector<ChunkPlace>& chunks) {
  std::sort(chunks.begin(), chunks.end(), [](const ChunkPlace& a, const ChunkPlace& b) { return a.where < b.where; });
  std::uint64_t end = 0;
  std::erase_if(chunks, [&](const ChunkPlace& chunk) {
    if (chunk.where < end) return true;
    end = chunk.data + chunk.data_size;
    return false;
  });
}

}  // namespace

std::vector<ChunkPlace> Contents::places() const {
  std::vector<ChunkPlace> all = chunks;
  all.insert(all.end(), loose.begin(), loose.end());
  return all;
}

const Schema* Contents::schema(std::uint16_t id) const {
  const auto it = std::find_if(schemas.begin(), schemas.end(), [&](const Schema& one) { return one.id == id; });
  return it == schemas.end() ? nullptr : &*it;
}

const Channel* Contents::channel(std::uint16_t id) const {
  const auto it = std::find_if(channels.begin(), channels.end(), [&](const Channel& one) { return one.id == id; });
  return it == channels.end() ? nullptr : &*it;
}

const Channel* Contents::channel(std::string_view topic) const {
  const auto it =
      std::find_if(channels.begin(), channels.end(), [&](const Channel& one) { return one.topic == topic; });
  return it == channels.end() ? nullptr : &*it;
}

bool is_mcap(const Source& source) {
  std::array<std::byte, kMagic.size()> magic{};
  if (source.size() < magic.size()) return false;
  source.read(0, magic);
  return std::memcmp(magic.data(), kMagic.data(), kMagic.size()) == 0;
}

Contents read_contents(const Source& source) {
  if (source.size() < kMagic.size()) throw Damage(0, "the file is too short for an MCAP file");
  if (!is_mcap(source)) throw Damage(0, "expected the start mark of an MCAP file, found other bytes");
  Contents contents;
  Known known;
  const Walk walk(source);
  std::uint64_t summary = 0;
  try {
    summary = walk.each_from(kMagic.size(), [&](const RecordHead& head) {
      try {
        return read_record(walk, head, known, contents);
      } catch (const BadBytes& bad) {  // its length is sound, so the next record can be read
        report(Damage(head.where, bad.what()), contents);
        return true;
      }
    });
  } catch (const Damage& damage) {
    report(damage, contents);
  }
  try {
    if (summary == 0) summary = summary_of(walk, source);
    if (summary > 0) read_summary(walk, source, summary, known, contents);
  } catch (const Damage& damage) {
    report(damage, contents);
  }
  sort_chunks(contents.chunks);
  return contents;
}

}  // namespace reorient::mcap
