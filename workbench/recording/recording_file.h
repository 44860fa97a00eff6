// The file that a recorder writes: on the disk within half a second, and readable up to there whatever happens.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

#include <sys/types.h>

#include "workbench/recording/mcap/writer.h"

namespace reorient {

class RecordingFile {
 public:
  /// Throws std::runtime_error with one line: what cannot be written, and why. So do all others.
  RecordingFile(const std::filesystem::path& file, const mcap::Texts& about);
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  void add(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data);
  /// Writes what is full or old. To be called at least every kFlushEvery.
  void keep_up();
  void finish();

  std::uint16_t frames() const { return frames_; }
  std::uint16_t states() const { return states_; }
  std::uint16_t images(std::size_t camera) const { return images_[camera]; }
  std::uint64_t size() const { return writer_->size(); }

  static constexpr std::chrono::milliseconds kFlushEvery{250};

 private:
  void write(std::span<const std::byte> bytes);
  void flush();

  std::filesystem::path file_;
  int descriptor_ = -1;
  off_t size_ = 0;  // bytes of whole records
  std::optional<mcap::Writer> writer_;
  std::uint16_t frames_ = 0, states_ = 0;
  std::array<std::uint16_t, 2> images_{};
  std::chrono::steady_clock::time_point flushed_;
  bool is_dirty_ = false;
};

}  // namespace reorient
