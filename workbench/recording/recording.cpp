// SPDX-License-Identifier: MIT
#include "workbench/recording/recording.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <stdexcept>
#include <utility>

#include "geometry/bytes.h"
#include "workbench/recording/packed_image.h"

namespace reorient {
namespace {

std::uint16_t channel_of(const mcap::Contents& contents, std::string_view topic, const std::string& file) {
  if (const mcap::Channel* const channel = contents.channel(topic)) return channel->id;
  if (contents.damage)
    throw std::runtime_error(file +
                             ": the file is damaged and contains no frames of reorient: " + contents.damage->what());
  throw std::runtime_error(file +
                           ": expected a recording of 'reorient run --record FILE', found no frames of reorient");
}

std::vector<std::byte> copy_of(std::span<const std::byte> bytes) { return {bytes.begin(), bytes.end()}; }

/// The content of a message of our own topics.
std::span<const std::byte> own_bytes(const mcap::Message& message) {
  ByteReader in(message.data);
  std::uint32_t length = 0;
  in(length);
  check_bytes(length == in.left(), "the length of a message differs from its bytes");
  return message.data.last(length);
}

}  // namespace

Recording::Recording(const std::filesystem::path& file) try
    : Recording(std::make_unique<mcap::FileSource>(file), file.string()) {
} catch (const mcap::Damage& damage) {
  throw std::runtime_error(file.string() + ": " + damage.what() + "; name a recording");
}

Recording::Recording(std::unique_ptr<mcap::Source> source, std::string name)
    : source_(std::move(source)), contents_(mcap::read_contents(*source_)), name_(std::move(name)) {
  if (contents_.damage) damages_.emplace_back(contents_.damage->what());
  for (const mcap::Metadata& metadata : contents_.metadata) {
    if (metadata.name == "reorient") about_ = metadata.texts;
  }
  read_format();
  frames_ = channel_of(contents_, kFrameTopic, name_);
  states_ = channel_of(contents_, kStateTopic, name_);
  for (std::size_t camera = 0; camera < images_.size(); ++camera)
    images_[camera] = channel_of(contents_, kImageTopics[camera], name_);
  find_view_topics();
}

/// All our recordings contain the format. If it is missing, that part of the file is damaged; each frame has its own
/// magic number.
void Recording::read_format() {
  const auto found = about_.find(std::string(kFormat));
  const std::string format = found == about_.end() ? "" : found->second;
  const auto [end, error] = std::from_chars(format.data(), format.data() + format.size(), format_);
  if (error == std::errc() && end == format.data() + format.size()) return;
  format_ = kRecordingFormat;
  damages_.emplace_back("at the beginning: the format is missing");
}

double Recording::begin_time() const {
  return contents_.chunks.empty() ? 0.0 : 1e-9 * static_cast<double>(contents_.chunks.front().start_time);
}

double Recording::end_time() const {
  std::uint64_t end = 0;
  for (const mcap::ChunkPlace& chunk : contents_.chunks) end = std::max(end, chunk.end_time);
  return 1e-9 * static_cast<double>(end);
}

void Recording::find_view_topics() {
  for (const mcap::Channel& channel : contents_.channels) {
    if (channel.id == frames_ || channel.id == states_ || std::count(images_.begin(), images_.end(), channel.id) > 0)
      continue;
    if (!view_of_.emplace(channel.id, view_topics_.size()).second) continue;
    ViewTopic& topic = view_topics_.emplace_back();
    topic.name = channel.topic;
    topic.encoding = channel.encoding;
    topic.lasts = channel.metadata.contains(std::string(kLasts));
    if (const mcap::Schema* const schema = contents_.schema(channel.schema)) {
      topic.schema = schema->name;
      topic.schema_encoding = schema->encoding;
      topic.schema_text = schema->text;
    }
  }
}

void Recording::require_this_format() const {
  if (format_ == kRecordingFormat) return;
  const auto version = about_.find("version");
  throw std::runtime_error(name_ + ": expected format " + std::to_string(kRecordingFormat) + ", found format " +
                           std::to_string(format_) + " of reorient " +
                           (version == about_.end() ? "of an unknown version" : version->second) +
                           " (replay it with that version; viewers and 'reorient recording info' can read it)");
}

void Recording::count_messages() {
  mcap::Message message;
  while (next_message(message)) {
  }
}

/// Drops the incomplete frame. The frame before the next one is unknown then.
void Recording::drop_pending() {
  pending_ = {};
  has_pending_ = {};
  last_frame_.reset();
}

bool Recording::go_to_chunk(std::size_t chunk) {
  chunk_ = chunk;
  messages_.reset();
  drop_pending();
  is_cut_ = true;
  return chunk_ < contents_.chunks.size();
}

bool Recording::next_message(mcap::Message& message) {
  while (true) {
    try {
      if (messages_ && messages_->next(message)) {
        Tally& tally = tallies_[message.channel];
        ++tally.messages;
        tally.bytes += message.data.size();
        return true;
      }
      if (chunk_ >= contents_.chunks.size()) return false;
      messages_.reset();
      const mcap::ChunkPlace& chunk = contents_.chunks[chunk_++];
      if (chunk.after_gap) {
        drop_pending();
        is_cut_ = true;
      }
      messages_.emplace(*source_, chunk);
    } catch (const mcap::Damage& damage) {  // the rest of the chunk is lost, with its incomplete frame
      damages_.emplace_back(damage.what());
      messages_.reset();
      drop_pending();
      is_cut_ = true;
    }
  }
}

bool Recording::next(RecordedFrame& frame) {
  require_this_format();
  mcap::Message message;
  while (next_message(message)) {
    if (message.channel == states_) {
      pending_.state = copy_of(own_bytes(message));
      continue;
    }
    const auto camera = std::find(images_.begin(), images_.end(), message.channel);
    if (camera != images_.end()) {
      const auto index = static_cast<std::size_t>(camera - images_.begin());
      unpack_image(own_bytes(message), pending_.images[index]);
      has_pending_[index] = true;
      continue;
    }
    if (message.channel != frames_) {
      const auto view = view_of_.find(message.channel);
      if (reads_views_ && view != view_of_.end())
        pending_.views.push_back({view->second, message.time, copy_of(message.data)});
      continue;
    }
    read_frame_entry(own_bytes(message), pending_.entry);
    const bool is_whole = pending_.entry.image_is_exact == has_pending_;
    if (!is_whole && std::exchange(is_cut_, false)) {  // its images were in the lost chunk
      drop_pending();
      continue;
    }
    check_bytes(is_whole, "a frame and its images do not match");
    is_cut_ = false;
    pending_.follows = last_frame_ && *last_frame_ + 1 == pending_.entry.frame;
    last_frame_ = pending_.entry.frame;
    std::swap(frame, pending_);
    pending_.state.clear();
    pending_.views.clear();
    has_pending_ = {};
    return true;
  }
  return false;
}

/// Searches backward from the first chunk after the time, because states are rare.
bool Recording::go_to(double time) {
  require_this_format();
  const auto& chunks = contents_.chunks;
  const auto nanoseconds = static_cast<std::uint64_t>(std::clamp(1e9 * time, 0.0, 9e18));
  std::size_t begin = 0;
  while (begin < chunks.size() && chunks[begin].start_time <= nanoseconds) ++begin;
  std::optional<std::size_t> found;  // the chunk
  std::uint64_t found_time = 0;
  const auto look = [&](std::size_t chunk) {
    go_to_chunk(chunk);
    try {
      mcap::ChunkMessages messages(*source_, chunks[chunk]);
      for (mcap::Message message; messages.next(message);) {
        if (message.channel != states_ || (found && message.time > nanoseconds)) continue;
        found = chunk;
        found_time = message.time;
      }
    } catch (const mcap::Damage&) {  // reported when it is read
    }
    return found.has_value();
  };
  for (std::size_t i = begin; i-- > 0;) {
    if (look(i) && found_time <= nanoseconds) break;
  }
  for (std::size_t i = begin; !found && i < chunks.size(); ++i) look(i);
  if (!found) return false;
  go_to_chunk(*found);
  // Skip what the chunk contains before that state, because it belongs to earlier frames.
  for (mcap::Message message; next_message(message);) {
    if (message.channel == states_ && message.time == found_time) {
      pending_.state = copy_of(own_bytes(message));
      return true;
    }
  }
  return false;
}

}  // namespace reorient
