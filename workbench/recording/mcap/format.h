// SPDX-License-Identifier: MIT
// The container format MCAP (mcap.dev/spec, version 0), as far as our recordings use it: records of an opcode, a length
// and a content; integers are little-endian, strings follow their length, times are in ns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace reorient::mcap {

inline constexpr std::array<unsigned char, 8> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// An opcode and a length come before each content.
inline constexpr std::size_t kRecordHead = 9;  // bytes

using Texts = std::map<std::string, std::string>;

struct Schema {
  std::uint16_t id = 0;  ///< not 0, which means no schema
  std::string name;
  std::string encoding;  ///< "jsonschema"
  std::string text;

  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  ///< 0: none
  std::string topic;
  std::string encoding;  ///< encoding of its messages: "json"
  Texts metadata;

  bool operator==(const Channel&) const = default;
};

/// Statistics of a whole file.
struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t attachments = 0;
  std::uint32_t metadata = 0;
  std::uint32_t chunks = 0;
  std::uint64_t first_time = 0, last_time = 0;         ///< ns; 0 without messages
  std::map<std::uint16_t, std::uint64_t> messages_of;  ///< by channel
};

}  // namespace reorient::mcap
