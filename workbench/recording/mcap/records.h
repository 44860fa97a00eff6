// SPDX-License-Identifier: MIT
// Contents of single records of an MCAP file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/format.h"

namespace reorient::mcap {

/// Reads a map or an array, which follows its length in bytes.
template <typename Each>
void read_sized(ByteReader& in, Each each) {
  std::uint32_t size = 0;
  in(size);
  check_bytes(size <= in.left(), "a list is longer than its record");
  for (const std::size_t end = in.left() - size; in.left() > end;) each(in);
}

inline Texts read_texts(ByteReader& in) {
  Texts texts;
  read_sized(in, [&](ByteReader& entries) {
    std::string key, value;
    entries(key, value);
    texts[key] = value;
  });
  return texts;
}

inline Schema read_schema(ByteReader in) {
  Schema schema;
  in(schema.id, schema.name, schema.encoding, schema.text);
  return schema;
}

inline Channel read_channel(ByteReader in) {
  Channel channel;
  in(channel.id, channel.schema, channel.topic, channel.encoding);
  channel.metadata = read_texts(in);
  return channel;
}

}  // namespace reorient::mcap
