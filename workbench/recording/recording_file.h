// SPDX-License-Identifier: MIT
// The file that a recorder writes: on the disk within half a second, and readable up to there after any failure.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "geometry/image.h"
#include "workbench/recording/frame_entry.h"
#include "workbench/recording/mcap/writer.h"

namespace reorient {

class RecordingFile {
 public:
  /// `views`: what there may be to look at. Throws std::runtime_error with one line: what cannot be written, and why;
  /// then a file that it has opened is gone. So do all others, but that what was written stays.
  RecordingFile(const std::filesystem::path& file, const mcap::Texts& about, std::vector<ViewTopic> views);
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  /// A frame: the state of the engine before it, which may be empty, those images that are exact, and what there is to
  /// look at, by its place among the topics.
  void add(const FrameEntry& entry, std::span<const std::byte> state, const std::array<ImageView, 2>& images,
           std::span<const ViewMessage> views);
  /// Writes what is full or old. To be called at least every kFlushEvery.
  void keep_up();
  /// Nothing may be added any more. Where it throws, the file may be whole all the same, without its last frames.
  void finish();

  const std::filesystem::path& path() const { return file_; }
  std::uint64_t size() const { return writer_->size(); }
  std::uint64_t frames() const { return writer_->messages_of(frames_); }  ///< that it has got

  static constexpr std::chrono::milliseconds kFlushEvery{250};

 private:
  /// Hands out `own_` behind its length.
  void add_own_message(std::uint16_t channel, std::uint64_t time);
  void add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data);
  std::uint16_t channel_of(std::size_t view);
  void write(std::span<const std::byte> bytes);
  void cut_to(off_t size);
  void flush();

  std::filesystem::path file_;
  int descriptor_ = -1;
  off_t size_ = 0;  // bytes of whole records
  std::optional<mcap::Writer> writer_;
  std::uint16_t frames_ = 0, states_ = 0;
  std::array<std::uint16_t, 2> images_{};
  struct View {
    ViewTopic topic;
    std::optional<std::uint16_t> channel;  // from its first message on
  };
  std::vector<View> views_;
  std::map<std::string, std::uint16_t> schemas_;
  std::vector<std::byte> own_;
  std::chrono::steady_clock::time_point flushed_;
  bool is_dirty_ = false;
  bool is_full_ = false;  // the disk was full at the last failed write
  bool is_finished_ = false;
};

}  // namespace reorient
