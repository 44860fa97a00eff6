// SPDX-License-Identifier: MIT
// Reads the frames of a recording in order, from any time on. Damaged parts are left out and reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/image.h"
#include "workbench/recording/frame_entry.h"
#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/data.h"
#include "workbench/recording/mcap/source.h"

namespace reorient {

struct RecordedFrame {
  FrameEntry entry;
  std::array<Image, 2> images;     ///< where entry.image_is_exact
  std::vector<std::byte> state;    ///< of the engine before it; empty: none was recorded here
  bool follows = false;            ///< the frame read before is the one before it
  std::vector<ViewMessage> views;  ///< messages for viewers, if the recording reads them, too
};

/// s; times of a recording are read off, and named again, with two decimals.
inline constexpr double kReadingError = 0.01;

class Recording {
 public:
  /// Throws std::runtime_error with one line: it cannot be read, or is not a recording of reorient.
  explicit Recording(const std::filesystem::path& file);
  /// `name`: for messages.
  explicit Recording(std::unique_ptr<mcap::Source> source, std::string name = "the recording");

  const mcap::Contents& contents() const { return contents_; }
  const mcap::Source& source() const { return *source_; }
  /// Metadata of the run: "scenario", "seed", "version".
  const mcap::Texts& about() const { return about_; }

  /// s of the robot: of its first and last message.
  double begin_time() const;
  double end_time() const;

  /// kRecordingFormat of the program that wrote it.
  int format() const { return format_; }
  /// Throws std::runtime_error with one line: what decides is of another format, and only to be counted.
  void require_this_format() const;

  /// What there is to look at, which read_views() has frames bring as well, by its place here.
  const std::vector<ViewTopic>& view_topics() const { return view_topics_; }
  void read_views() { reads_views_ = true; }

  /// The next frame in its order. False: no frame is left. Throws std::runtime_error with one line: of another
  /// format; BadBytes: it is not what it should be.
  bool next(RecordedFrame& frame);
  /// The next frame is the latest with a state of the engine that is not after `time` (s of the robot), or else the
  /// first that has one. False: no frame has one.
  bool go_to(double time);

  /// Reads all messages that are left, and only counts them: of any format.
  void count_messages();
  /// What was read so far, by channel.
  struct Tally {
    std::uint64_t messages = 0, bytes = 0;
  };
  const std::map<std::uint16_t, Tally>& tallies() const { return tallies_; }
  /// What could not be read so far, in words.
  const std::vector<std::string>& damages() const { return damages_; }

 private:
  void read_format();
  void find_view_topics();
  void drop_pending();
  bool next_message(mcap::Message& message);
  bool go_to_chunk(std::size_t chunk);

  std::unique_ptr<mcap::Source> source_;
  mcap::Contents contents_;
  mcap::Texts about_;
  std::string name_;  // for messages
  int format_ = kRecordingFormat;
  std::uint16_t frames_ = 0, states_ = 0;  // channels
  std::array<std::uint16_t, 2> images_{};
  std::vector<ViewTopic> view_topics_;
  std::map<std::uint16_t, std::size_t> view_of_;  // by channel
  bool reads_views_ = false;

  std::size_t chunk_ = 0;  // the next
  std::optional<mcap::ChunkMessages> messages_;
  RecordedFrame pending_;  // what came before its frame
  std::array<bool, 2> has_pending_{};
  bool is_cut_ = false;  // what came before the next frame may have been left out
  std::optional<std::uint64_t> last_frame_;
  std::map<std::uint16_t, Tally> tallies_;
  std::vector<std::string> damages_;
};

}  // namespace reorient
