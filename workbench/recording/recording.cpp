// SPDX-License-Identifier: MIT
#include "workbench/recording/recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "geometry/bytes.h"
#include "workbench/recording/mcap/topics.h"
#include "workbench/recording/packed_image.h"

namespace reorient {
namespace {

std::vector<std::byte> copy_of(std::span<const std::byte> bytes) { return {bytes.begin(), bytes.end()}; }

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << seconds << " s";
  return text.str();
}

/// The content of a message of our own topics.
std::span<const std::byte> own_bytes(const mcap::Message& message) {
  ByteReader in(message.data);
  std::uint32_t length = 0;
  in(length);
  check_bytes(length == in.left(), "the length of a message differs from its bytes");
  return message.data.last(length);
}

}  // namespace

Recording::Recording(const std::filesystem::path& file)
    : Recording(std::make_unique<mcap::FileSource>(file), file.string()) {}

Recording::Recording(const std::filesystem::path& file, std::function<bool()> stop)
    : Recording(std::make_unique<mcap::StoppableSource>(file, std::move(stop)), file.string()) {}

Recording::Recording(std::unique_ptr<mcap::Source> source, const std::string& name) try
    : source_(std::move(source)), contents_(mcap::read_contents(*source_)), name_(name) {
  if (contents_.damage) add_damage(contents_.damage->what());
  mcap::read_topics_in_chunks(*source_, contents_);
  places_ = contents_.places();
  std::erase_if(places_, [](const mcap::ChunkPlace& place) { return place.size == 0; });  // and without times
  std::sort(places_.begin(), places_.end(), [](const mcap::ChunkPlace& a, const mcap::ChunkPlace& b) {
    return std::tie(a.start_time, a.where) < std::tie(b.start_time, b.where);
  });
  for (const mcap::Metadata& metadata : contents_.metadata) {
    if (metadata.name == "reorient") about_ = metadata.texts;
  }
  read_format();
  find_uses();
} catch (const mcap::Damage& damage) {
  throw std::runtime_error(name + ": " + damage.what() + "; name a recording");
}

/// All our recordings contain the format, but other tools may leave the metadata out. Each frame has its own magic
/// number.
void Recording::read_format() {
  if (about_.empty()) return;
  const auto found = about_.find(std::string(kFormat));
  const std::string format = found == about_.end() ? "" : found->second;
  const auto [end, error] = std::from_chars(format.data(), format.data() + format.size(), format_);
  if (error == std::errc() && end == format.data() + format.size()) return;
  format_ = kRecordingFormat;
  add_damage("at the beginning: the format is missing");
}

double Recording::begin_time() const {
  return places_.empty() ? 0.0 : 1e-9 * static_cast<double>(places_.front().start_time);
}

double Recording::end_time() const {
  std::uint64_t end = 0;
  for (const mcap::ChunkPlace& place : places_) end = std::max(end, place.end_time);
  return 1e-9 * static_cast<double>(end);
}

/// A file may have several channels of a topic. Only the frames are needed by every reader.
void Recording::find_uses() {
  bool has_frames = false;
  for (const mcap::Channel& channel : contents_.channels) {
    Use use;
    const auto camera = std::find(kImageTopics.begin(), kImageTopics.end(), channel.topic);
    if (channel.topic == kFrameTopic) {
      use.kind = Use::Kind::frame;
      has_frames = true;
    } else if (channel.topic == kStateTopic) {
      use.kind = Use::Kind::state;
    } else if (camera != kImageTopics.end()) {
      use = {Use::Kind::image, static_cast<std::size_t>(camera - kImageTopics.begin())};
    } else {
      use.index = view_topics_.size();
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
    uses_.emplace(channel.id, use);
  }
  if (has_frames) return;
  throw std::runtime_error(name_ + (contents_.damage
                                        ? std::string(": the file is damaged and contains no frames of reorient: ") +
                                              contents_.damage->what()
                                        : ": expected a recording of 'reorient run --record FILE', found no frames of "
                                          "reorient (topic " +
                                              std::string(kFrameTopic) + ")"));
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

/// Begins with the messages at or after a time, ns.
void Recording::start(std::uint64_t from) {
  std::vector<mcap::ChunkPlace> places;
  std::copy_if(places_.begin(), places_.end(), std::back_inserter(places),
               [from](const mcap::ChunkPlace& place) { return place.end_time >= from; });
  std::set<std::uint16_t> channels;
  for (const auto& [channel, use] : uses_) {
    const bool is_read = use.kind == Use::Kind::view    ? reads_views_
                         : use.kind == Use::Kind::image ? reads_images_
                                                        : true;
    if (is_read) channels.insert(channel);
  }
  messages_.emplace(*source_, std::move(places), std::move(channels));
  from_ = from;
  next_.reset();
  pending_ = {};
  pending_time_ = 0;
  has_frame_ = false;
  has_image_ = {};
  view_bytes_ = 0;
  last_frame_.reset();
  frames_ = 0;
  losses_ = {};
  is_over_ = false;
  is_read_from_begin_ = places_.empty() || from <= places_.front().start_time;
}

bool Recording::next_message(mcap::Message& message) {
  if (!messages_) start(0);
  while (true) {
    try {
      if (!messages_->next(message)) return false;
      if (message.time < from_) continue;
      Tally& tally = tallies_[message.channel];
      ++tally.messages;
      tally.bytes += message.data.size();
      return true;
    } catch (const mcap::Damage& damage) {  // the rest of the chunk is lost
      losses_.unknown = true;
      add_damage(damage.what());
    }
  }
}

bool Recording::next(RecordedFrame& frame) {
  require_this_format();
  mcap::Message message;
  while (true) {
    if (next_) {
      message = *std::exchange(next_, std::nullopt);
    } else if (!next_message(message)) {
      is_over_ = true;
      if (!has_frame_) return false;
      give(frame);
      return true;
    }
    const Use& use = uses_.at(message.channel);
    // Two frames may have the same time: what a frame has already, or does not need, belongs to the next one.
    const bool is_of_next =
        use.kind == Use::Kind::image
            ? has_image_[use.index] || !pending_.entry.image_is_exact[use.index]
            : use.kind == Use::Kind::frame || (use.kind == Use::Kind::state && !pending_.state.empty());
    // Frames without a valid time are recorded at 0 ns and are in our own order: a frame comes after what belongs to
    // it.
    const bool has_time = message.time != 0 || std::abs(pending_.entry.time) < 1e-9;
    if (has_frame_ && (message.time != pending_time_ || !has_time || is_of_next)) {
      next_ = message;
      give(frame);
      return true;
    }
    if (message.time != pending_time_) {  // what was collected has no frame
      pending_time_ = message.time;
      pending_.state.clear();
      has_image_ = {};
    }
    try {
      take(message, use);
    } catch (const BadBytes& bad) {
      add_damage("at byte " + std::to_string(messages_->where()) + ": " + contents_.channel(message.channel)->topic +
                 " at " + seconds_text(1e-9 * static_cast<double>(message.time)) + ": " + bad.what());
    }
  }
}

void Recording::take(const mcap::Message& message, const Use& use) {
  switch (use.kind) {
    case Use::Kind::frame:
      read_frame_entry(own_bytes(message), pending_.entry);
      has_frame_ = true;
      return;
    case Use::Kind::state:
      pending_.state = copy_of(own_bytes(message));
      return;
    case Use::Kind::image:
      unpack_image(own_bytes(message), pending_.images[use.index]);
      has_image_[use.index] = true;
      return;
    case Use::Kind::view:
      if (view_bytes_ > kMostViewBytes) return;
      view_bytes_ += message.data.size() + sizeof(ViewMessage);
      if (view_bytes_ > kMostViewBytes) throw BadBytes("a frame has too many messages for viewers");
      pending_.views.push_back({use.index, message.time, copy_of(message.data)});
      return;
  }
}

/// Completes the collected frame and begins the next one.
void Recording::give(RecordedFrame& frame) {
  FrameEntry& entry = pending_.entry;
  bool lacks_image = false;
  for (std::size_t camera = 0; camera < has_image_.size(); ++camera) {
    if (!entry.image_is_exact[camera] || has_image_[camera]) continue;
    entry.image_is_exact[camera] = false;
    lacks_image = true;
  }
  if (lacks_image && reads_images_ && losses_.images++ == 0) add_damage(pending_, "an image of this frame is missing");
  pending_.follows = last_frame_ && *last_frame_ + 1 == entry.frame;
  if (last_frame_ && entry.frame > *last_frame_ + 1) losses_.frames += entry.frame - *last_frame_ - 1;
  last_frame_ = entry.frame;
  ++frames_;
  std::swap(frame, pending_);
  pending_.state.clear();
  pending_.views.clear();
  view_bytes_ = 0;
  has_frame_ = false;
  has_image_ = {};
}

/// Searches backward from the first chunk after the time, because states are rare.
bool Recording::go_to(double time) {
  require_this_format();
  const auto nanoseconds = static_cast<std::uint64_t>(std::clamp(1e9 * time, 0.0, 9e18));
  std::optional<std::uint64_t> found;  // ns
  const auto is_before = [&] { return found && *found <= nanoseconds; };
  const auto look = [&](const mcap::ChunkPlace& place) {
    try {
      mcap::ChunkMessages messages(*source_, place);
      for (mcap::Message message; messages.next(message);) {
        const auto use = uses_.find(message.channel);
        if (use == uses_.end() || use->second.kind != Use::Kind::state) continue;
        if (message.time <= nanoseconds ? !is_before() || message.time > *found : !found || message.time < *found)
          found = message.time;
      }
    } catch (const mcap::Damage&) {  // reported when it is read
    }
  };
  const auto begin = std::find_if(places_.begin(), places_.end(),
                                  [&](const mcap::ChunkPlace& place) { return place.start_time > nanoseconds; });
  for (auto place = std::make_reverse_iterator(begin); place != places_.rend(); ++place) {
    if (!is_before() || place->end_time > *found) look(*place);
  }
  for (auto place = begin; !is_before() && place != places_.end(); ++place) {
    if (!found || place->start_time < *found) look(*place);
  }
  if (!found) return false;
  start(*found);
  return true;
}

/// The number of frames that the summary contains.
std::optional<std::uint64_t> Recording::stated_frames() const {
  if (!contents_.statistics || contents_.statistics->messages_of.empty()) return std::nullopt;
  std::uint64_t stated = 0;
  for (const auto& [channel, count] : contents_.statistics->messages_of) {
    const auto use = uses_.find(channel);
    if (use != uses_.end() && use->second.kind == Use::Kind::frame) stated += count;
  }
  return stated;
}

Recording::Losses Recording::losses() const {
  Losses losses = losses_;
  losses.unknown = false;
  if (!is_over_ || !is_read_from_begin_) return losses;
  // Before the first and after the last frame, numbers of frames show no gap.
  std::uint64_t found = 0;
  for (const auto& [channel, tally] : tallies_) {
    if (uses_.at(channel).kind == Use::Kind::frame) found += tally.messages;
  }
  const std::optional<std::uint64_t> stated = stated_frames();
  const std::uint64_t recorded = std::max(found, stated.value_or(0));
  if (recorded > frames_) losses.frames = std::max(losses.frames, recorded - frames_);
  // If the file ends between two records, no data is known to be lost.
  const bool has_gap = contents_.damage && contents_.damage->where != source_->size();
  losses.unknown = !stated && (losses_.unknown || has_gap);
  return losses;
}

void Recording::add_damage(const std::string& damage) {
  if (damages_.size() < kMostDamages) {
    damages_.push_back(damage);
  } else if (damages_.size() == kMostDamages) {
    damages_.emplace_back("and at more places");
  }
}

void Recording::add_damage(const RecordedFrame& frame, const std::string& what) {
  add_damage("at " + seconds_text(frame.entry.time) + ": frame " + std::to_string(frame.entry.frame) + ": " + what);
}

}  // namespace reorient
