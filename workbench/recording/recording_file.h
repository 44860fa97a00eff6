// SPDX-License-Identifier: MIT
// The file of a recorder. Its data is on the disk within half a second, and readable up to there after any failure.
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
  /// Treatment of a file that exists.
  enum class Existing { is_replaced, stays };

  /// `views`: the possible topics for viewers. Locks the file, so that no second process writes it. Throws
  /// std::runtime_error with one line if the file cannot be written, is being written by another process, or exists and
  /// `existing` says that it stays. Removes an incomplete new file then. The other functions throw the same, but the
  /// written data remains.
  RecordingFile(const std::filesystem::path& file, const mcap::Texts& about, std::vector<ViewTopic> views,
                Existing existing = Existing::is_replaced);
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  /// Adds a frame: the state of the engine before it, which may be empty, its exact images, and its messages for
  /// viewers by the index of their topic.
  void add(const FrameEntry& entry, std::span<const std::byte> state, const std::array<ImageView, 2>& images,
           std::span<const ViewMessage> views);
  /// Writes full chunks and old data. Call it at least every kFlushEvery.
  void keep_up();
  /// Ends the file; nothing may be added afterwards. If it throws, the file may still be complete, without its last
  /// frames.
  void finish();
  /// Throws std::runtime_error with one line if the path does not name the written data any more: another program
  /// removed, replaced or changed the file.
  void require_in_place() const;
  /// A descriptor that holds the lock of the file, also after this object is destroyed. The caller closes it; -1:
  /// failed.
  int share_lock() const;

  const std::filesystem::path& path() const { return file_; }
  std::uint64_t size() const { return writer_->size(); }
  std::uint64_t frames() const { return writer_->messages_of(frames_); }  ///< number of added frames

  static constexpr std::chrono::milliseconds kFlushEvery{250};

 private:
  /// Returns `own_` after its length.
  void add_own_message(std::uint16_t channel, std::uint64_t time);
  void add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data);
  std::uint16_t channel_of(std::size_t view);
  void write(std::span<const std::byte> bytes);
  void cut_to(off_t size);
  void flush();

  std::filesystem::path file_;
  int descriptor_ = -1;
  off_t size_ = 0;  // bytes of complete records
  std::optional<mcap::Writer> writer_;
  std::uint16_t frames_ = 0, states_ = 0;
  std::array<std::uint16_t, 2> images_{};
  struct View {
    ViewTopic topic;
    std::optional<std::uint16_t> channel;  // set with its first message
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
