// SPDX-License-Identifier: MIT
#include "tests/workbench/recording/foreign_recording.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <tuple>

#include "geometry/bytes.h"
#include "tests/workbench/recording/raw_mcap.h"
#include "workbench/recording/frame_entry.h"
#include "workbench/recording/mcap/checksum.h"
#include "workbench/recording/mcap/data.h"

namespace reorient {
namespace {

using mcap::Opcode;
using mcap::RawMcap;
using Layout = ForeignShape::Layout;
using Order = ForeignShape::Order;
using Summary = ForeignShape::Summary;

void add_unknown_record(RawMcap& file) {
  constexpr std::uint8_t kPrivate = 0x9A;
  file.record(static_cast<Opcode>(kPrivate), std::vector<std::byte>(11, std::byte{0x33}));
}

std::vector<RawRecording::Message> in_order(const RawRecording& recording, Order order) {
  std::vector<RawRecording::Message> messages = recording.messages;
  const std::uint16_t frames = recording.channel(kFrameTopic);
  if (order == Order::frames_first) {
    std::stable_sort(messages.begin(), messages.end(), [&](const auto& a, const auto& b) {
      return std::tuple(a.time, a.channel != frames) < std::tuple(b.time, b.channel != frames);
    });
  } else if (order == Order::by_topic) {
    std::stable_sort(messages.begin(), messages.end(),
                     [](const auto& a, const auto& b) { return a.channel > b.channel; });
  }
  return messages;
}

}  // namespace

std::uint16_t RawRecording::channel(std::string_view topic) const {
  for (const mcap::Channel& channel : channels) {
    if (channel.topic == topic) return channel.id;
  }
  throw std::runtime_error("no topic " + std::string(topic));
}

void RawRecording::remove(std::string_view topic) {
  const std::uint16_t id = channel(topic);
  std::erase_if(channels, [id](const mcap::Channel& channel) { return channel.id == id; });
  std::erase_if(messages, [id](const Message& message) { return message.channel == id; });
}

std::vector<RawRecording::Message*> RawRecording::of(std::string_view topic) {
  const std::uint16_t id = channel(topic);
  std::vector<Message*> all;
  for (Message& message : messages) {
    if (message.channel == id) all.push_back(&message);
  }
  return all;
}

RawRecording raw_recording(const std::filesystem::path& file) {
  const mcap::FileSource source(file);
  mcap::Contents contents = mcap::read_contents(source);
  RawRecording recording{std::move(contents.schemas), std::move(contents.channels), std::move(contents.metadata), {}};
  for (const mcap::ChunkPlace& place : contents.chunks) {
    mcap::ChunkMessages messages(source, place);
    for (mcap::Message message; messages.next(message);)
      recording.messages.push_back({message.channel, message.time, {message.data.begin(), message.data.end()}});
  }
  return recording;
}

std::string ForeignShape::name() const {
  static constexpr const char* kLayouts[] = {"chunks", "loose", "mixed"};
  static constexpr const char* kOrders[] = {"recorded", "frames_first", "by_topic"};
  static constexpr const char* kSummaries[] = {"no_summary", "channels", "summary"};
  std::string name = kLayouts[static_cast<int>(layout)];
  name.append("_").append(compression.empty() ? "plain" : compression);
  name.append("_").append(kOrders[static_cast<int>(order)]);
  name.append("_").append(kSummaries[static_cast<int>(summary)]);
  if (channels_in_chunks) name += "_channels_in_chunks";
  if (padded) name += "_padded";
  if (bare) name += "_bare";
  return name;
}

std::vector<ForeignShape> all_foreign_shapes() {
  std::vector<ForeignShape> shapes;
  for (const Layout layout : {Layout::chunks, Layout::loose, Layout::mixed}) {
    for (const char* const compression : {"", "lz4", "zstd"}) {
      for (const Order order : {Order::recorded, Order::frames_first, Order::by_topic}) {
        for (const Summary summary : {Summary::none, Summary::channels, Summary::full}) {
          for (int flags = 0; flags < 8; ++flags) {
            const ForeignShape shape{layout,           compression,      order,           summary,
                                     (flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0};
            const bool needs_chunks = !shape.compression.empty() || shape.channels_in_chunks;
            if (layout != Layout::loose || !needs_chunks) shapes.push_back(shape);
          }
        }
      }
    }
  }
  return shapes;
}

std::vector<std::byte> written_as(const RawRecording& recording, const ForeignShape& shape) {
  const std::vector<RawRecording::Message> messages = in_order(recording, shape.order);
  std::map<std::uint16_t, std::uint64_t> counts;
  for (const RawRecording::Message& message : messages) ++counts[message.channel];
  std::vector<mcap::Channel> channels = recording.channels;
  if (shape.bare) std::erase_if(channels, [&](const mcap::Channel& channel) { return !counts.contains(channel.id); });

  RawMcap file, summary;
  if (shape.padded) file.pad(), summary.pad();
  file.magic();
  file.header();
  if (!shape.bare) {
    for (const mcap::Metadata& metadata : recording.metadata) file.metadata(metadata.name, metadata.texts);
  }
  const auto describe = [&](RawMcap& out) {
    for (const mcap::Schema& schema : recording.schemas) out.schema(schema);
    for (const mcap::Channel& channel : channels) out.channel(channel);
  };
  if (!shape.channels_in_chunks || shape.layout == Layout::mixed) describe(file);
  if (shape.summary != Summary::none) describe(summary);

  constexpr std::size_t kInAChunk = 16;
  std::uint32_t chunks = 0;
  for (std::size_t i = 0; i < messages.size(); i += kInAChunk) {
    const bool is_loose = shape.layout == Layout::loose || (shape.layout == Layout::mixed && i / kInAChunk % 2 == 1);
    RawMcap chunk;
    if (shape.channels_in_chunks) describe(chunk);
    if (shape.padded) add_unknown_record(is_loose ? file : chunk);
    for (std::size_t k = i; k < std::min(i + kInAChunk, messages.size()); ++k)
      (is_loose ? file : chunk).message(messages[k].channel, messages[k].time, messages[k].data);
    if (is_loose) continue;
    const std::uint64_t where = file.bytes().size();
    file.chunk(chunk, shape.compression);
    ++chunks;
    if (shape.summary == Summary::full)
      summary.chunk_index(chunk, where, file.bytes().size() - where, shape.compression);
    if (shape.padded) add_unknown_record(file);
  }
  if (shape.summary == Summary::none) {
    file.end();
    return file.bytes();
  }
  if (shape.summary == Summary::full) {
    std::uint64_t first = ~std::uint64_t{0}, last = 0;
    for (const RawRecording::Message& message : messages) {
      first = std::min(first, message.time);
      last = std::max(last, message.time);
    }
    std::vector<std::byte> content;
    ByteWriter out(content);
    out(static_cast<std::uint64_t>(messages.size()), static_cast<std::uint16_t>(recording.schemas.size()),
        static_cast<std::uint32_t>(channels.size()), std::uint32_t{0},
        static_cast<std::uint32_t>(shape.bare ? 0 : recording.metadata.size()), chunks, first, last,
        static_cast<std::uint32_t>(counts.size() * (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
    for (const auto& [channel, count] : counts) out(channel, count);
    summary.record(Opcode::statistics, content);
  }
  file.end(summary);
  return file.bytes();
}

}  // namespace reorient
