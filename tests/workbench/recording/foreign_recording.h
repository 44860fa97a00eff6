// SPDX-License-Identifier: MIT
// Recordings as other tools write them: the same messages in other records. The MCAP format allows much that our own
// writer never does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/mcap/contents.h"

namespace reorient {

/// The contents of a recording, which a test may change before another tool "writes" it.
struct RawRecording {
  struct Message {
    std::uint16_t channel = 0;
    std::uint64_t time = 0;  ///< ns
    std::vector<std::byte> data;
  };
  std::vector<mcap::Schema> schemas;
  std::vector<mcap::Channel> channels;
  std::vector<mcap::Metadata> metadata;
  std::vector<Message> messages;

  /// Number of the channel of a topic. Throws if it is missing.
  std::uint16_t channel(std::string_view topic) const;
  /// Removes a topic with its messages, as a filter does.
  void remove(std::string_view topic);
  /// The messages of a topic, in their order.
  std::vector<Message*> of(std::string_view topic);
};

RawRecording raw_recording(const std::filesystem::path& file);

/// A combination of what the format allows.
struct ForeignShape {
  enum class Layout { chunks, loose, mixed } layout = Layout::chunks;
  std::string compression = "zstd";  ///< "", "lz4", "zstd"
  enum class Order { recorded, frames_first, by_topic } order = Order::recorded;
  enum class Summary { none, channels, full } summary = Summary::full;
  bool channels_in_chunks = false;  ///< schemas and channels are in the chunks, not before them
  bool padded = false;              ///< unknown records, and more bytes at the end of known ones
  bool bare = false;                ///< no metadata, and no channels without messages

  std::string name() const;
};

/// All combinations that differ.
std::vector<ForeignShape> all_foreign_shapes();

std::vector<std::byte> written_as(const RawRecording& recording, const ForeignShape& shape);

}  // namespace reorient
