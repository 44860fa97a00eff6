// SPDX-License-Identifier: MIT
// Reads the frames of a recording in order, starting at any time, also if another tool wrote the file: in any order, in
// chunks or outside of them, without some topics. Damaged parts are skipped and reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/frame_source.h"
#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/data.h"
#include "workbench/recording/mcap/ordered_messages.h"
#include "workbench/recording/mcap/source.h"

namespace reorient {

class Recording : public FrameSource {
 public:
  /// Throws std::runtime_error with one line if the file cannot be read or is not a recording of reorient.
  explicit Recording(const std::filesystem::path& file);
  /// The same, but `stop` ends long reads: once it returns true, all functions that read throw mcap::Stopped.
  Recording(const std::filesystem::path& file, std::function<bool()> stop);
  /// `name`: for messages.
  explicit Recording(std::unique_ptr<mcap::Source> source, const std::string& name = "the recording");

  const std::string& name() const { return name_; }
  const mcap::Contents& contents() const { return contents_; }
  const mcap::Source& source() const { return *source_; }
  /// Metadata of the run: "scenario", "seed", "version". Empty if another tool left them out.
  const mcap::Texts& about() const { return about_; }

  /// Times of the first and the last message, s of the robot.
  double begin_time() const;
  double end_time() const;

  /// kRecordingFormat of the program that wrote it.
  int format() const { return format_; }
  /// Throws std::runtime_error with one line if the frames have another format, so that they can only be counted.
  void require_this_format() const;

  /// Topics for viewers. After read_views(), frames contain their messages, with indices into this list, and tallies()
  /// counts them. Call it before the first frame is read.
  const std::vector<ViewTopic>& view_topics() const { return view_topics_; }
  void read_views() { reads_views_ = true; }
  /// Frames then have no images, and missing images are no loss. Call it before the first frame is read.
  void leave_out_images() { reads_images_ = false; }
  /// Most bytes of messages for viewers that a frame contains; the rest are left out.
  static constexpr std::size_t kMostViewBytes = std::size_t{64} << 20;

  /// The next frame; false after the last one. Leaves out what cannot be read. Throws std::runtime_error with one line
  /// if the format is another one.
  bool next(RecordedFrame& frame) override;
  bool go_to(double time) override;

  /// Counts the remaining messages, of any format.
  void count_messages();
  /// Numbers of messages and bytes so far, by channel.
  struct Tally {
    std::uint64_t messages = 0, bytes = 0;
  };
  const std::map<std::uint16_t, Tally>& tallies() const { return tallies_; }

  /// What is missing between the frames so far. After the last frame also what is missing before and after them, if the
  /// recording was read from its beginning.
  struct Losses {
    std::uint64_t frames = 0;
    std::uint64_t images = 0;  ///< frames without an image that was recorded
    bool unknown = false;      ///< frames may be missing whose number the file does not contain
    bool any() const { return frames > 0 || images > 0 || unknown; }
  };
  Losses losses() const;
  /// Descriptions of the damages that were found so far, with their positions; at most kMostDamages and a last line.
  const std::vector<std::string>& damages() const { return damages_; }
  static constexpr std::size_t kMostDamages = 20;
  void add_damage(const RecordedFrame& frame, const std::string& what) override;

 private:
  /// What a channel contains.
  struct Use {
    enum class Kind { frame, state, image, view } kind = Kind::view;
    std::size_t index = 0;  // of the camera, or of the topic for viewers
  };
  void read_format();
  void find_uses();
  void start(std::uint64_t from);
  bool next_message(mcap::Message& message);
  void take(const mcap::Message& message, const Use& use);
  void give(RecordedFrame& frame);
  std::optional<std::uint64_t> stated_frames() const;
  void add_damage(const std::string& damage);

  std::unique_ptr<mcap::Source> source_;
  mcap::Contents contents_;
  std::vector<mcap::ChunkPlace> places_;  // by start time
  mcap::Texts about_;
  std::string name_;  // for messages
  int format_ = kRecordingFormat;
  std::map<std::uint16_t, Use> uses_;  // by channel
  std::vector<ViewTopic> view_topics_;
  bool reads_views_ = false, reads_images_ = true;

  std::optional<mcap::OrderedMessages> messages_;
  std::uint64_t from_ = 0;             // ns; earlier messages are skipped
  std::optional<mcap::Message> next_;  // already read, belongs to the next frame
  // The frame that is being collected. Its messages have the same time, in any order.
  RecordedFrame pending_;
  std::uint64_t pending_time_ = 0;  // ns
  bool has_frame_ = false;
  std::array<bool, 2> has_image_{};
  std::size_t view_bytes_ = 0;

  bool is_read_from_begin_ = true, is_over_ = false;
  std::optional<std::uint64_t> last_frame_;
  std::uint64_t frames_ = 0;  // read
  Losses losses_;
  std::map<std::uint16_t, Tally> tallies_;
  std::vector<std::string> damages_;
};

}  // namespace reorient
