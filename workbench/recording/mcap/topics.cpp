// SPDX-License-Identifier: MIT
#include "workbench/recording/mcap/topics.h"

#include <cstddef>
#include <utility>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/data.h"
#include "workbench/recording/mcap/records.h"

namespace reorient::mcap {
namespace {

bool has_all_topics(const Contents& contents) {
  const std::optional<Statistics>& statistics = contents.statistics;
  return contents.is_complete && statistics && contents.channels.size() >= statistics->channels &&
         contents.schemas.size() >= statistics->schemas;
}

}  // namespace

void read_topics_in_chunks(const Source& source, Contents& contents) {
  if (has_all_topics(contents)) return;
  constexpr std::size_t kMost = 4096;  // channels, and as many schemas
  for (const ChunkPlace& place : contents.chunks) {
    try {
      ChunkMessages records(source, place);
      for (ChunkRecord record; records.next(record);) {
        if (record.opcode == Opcode::schema && contents.schemas.size() < kMost) {
          Schema schema = read_schema(ByteReader(record.content));
          if (contents.schema(schema.id) == nullptr) contents.schemas.push_back(std::move(schema));
        } else if (record.opcode == Opcode::channel && contents.channels.size() < kMost) {
          Channel channel = read_channel(ByteReader(record.content));
          if (contents.channel(channel.id) == nullptr) contents.channels.push_back(std::move(channel));
        }
      }
    } catch (const BadBytes&) {  // both are reported when the chunk is read
    } catch (const Damage&) {
    }
  }
}

}  // namespace reorient::mcap
