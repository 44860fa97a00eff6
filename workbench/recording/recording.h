// SPDX-License-Identifier: MIT
// Reads the frames of a recording in order, starting at any time. Damaged parts are skipped and reported.
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
  std::array<Image, 2> images;     ///< valid if entry.image_is_exact
  std::vector<std::byte> state;    ///< of the engine before the frame; empty: not recorded here
  bool follows = false;            ///< the previously read frame is its predecessor
  std::vector<ViewMessage> views;  ///< messages for viewers, if the recording reads them, too
};

/// Tolerance in s, because users read and enter times of a recording with two decimals.
inline constexpr double kReadingError = 0.01;

class Recording {
 public:
  /// Throws std::runtime_error with one line if the file cannot be read or is not a recording of reorient.
  explicit Recording(const std::filesystem::path& file);
  /// `name`: for messages.
  explicit Recording(std::unique_ptr<mcap::Source> source, std::string name = "the recording");

  const mcap::Contents& contents() const { return contents_; }
  const mcap::Source& source() const { return *source_; }
  /// Metadata of the run: "scenario", "seed", "version".
  const mcap::Texts& about() const { return about_; }

  /// Times of the first and the last message, s of the robot.
  double begin_time() const;
  double end_time() const;

  /// kRecordingFormat of the program that wrote it.
  int format() const { return format_; }
  /// Throws std::runtime_error with one line if the frames have another format, so that they can only be counted.
  void require_this_format() const;

  /// Topics for viewers. After read_views(), frames contain their messages, with indices into this list.
  const std::vector<ViewTopic>& view_topics() const { return view_topics_; }
  void read_views() { reads_views_ = true; }

  /// The next frame; false after the last one. Throws std::runtime_error with one line if the format is another one,
  /// and BadBytes if the frame is invalid.
  bool next(RecordedFrame& frame);
  /// Makes the next frame the latest one with a state of the engine at or before `time` (s of the robot), or else the
  /// first one with a state. False: no frame has a state.
  bool go_to(double time);

  /// Counts the remaining messages, of any format.
  void count_messages();
  /// Numbers of messages and bytes so far, by channel.
  struct Tally {
    std::uint64_t messages = 0, bytes = 0;
  };
  const std::map<std::uint16_t, Tally>& tallies() const { return tallies_; }
  /// Descriptions of the damages that were found so far.
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
  std::uint16_t frames_ = 0, states_ = 0;  // numbers of channels
  std::array<std::uint16_t, 2> images_{};
  std::vector<ViewTopic> view_topics_;
  std::map<std::uint16_t, std::size_t> view_of_;  // by channel
  bool reads_views_ = false;

  std::size_t chunk_ = 0;  // index of the next one
  std::optional<mcap::ChunkMessages> messages_;
  RecordedFrame pending_;  // data that precedes its frame
  std::array<bool, 2> has_pending_{};
  bool is_cut_ = false;  // data before the next frame may be missing
  std::optional<std::uint64_t> last_frame_;
  std::map<std::uint16_t, Tally> tallies_;
  std::vector<std::string> damages_;
};

}  // namespace reorient
