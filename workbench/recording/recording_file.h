// The file that a recorder writes: on the disk within half a second, and readable up to there whatever happens.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <sys/types.h>

#include "workbench/recording/frame_entry.h"
#include "workbench/recording/mcap/writer.h"

namespace reorient {

class RecordingFile {
 public:
  /// Throws std::runtime_error with one line: what cannot be written, and why. So do all others.
  RecordingFile(const std::filesystem::path& file, const mcap::Texts& about);
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  /// A frame: the state of the engine before it, which may be empty, and those images that are exact.
  void add(const FrameEntry& entry, std::span<const std::byte> state, const std::array<ImageView, 2>& images);
  /// Writes what is full or old. To be called at least every kFlushEvery.
  void keep_up();
  void finish();

  std::uint64_t size() const { return writer_->size(); }

  static constexpr std::chrono::milliseconds kFlushEvery{250};

 private:
  void add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data);
  void write(std::span<const std::byte> bytes);
  void flush();

  std::filesystem::path file_;
  int descriptor_ = -1;
  off_t size_ = 0;  // bytes of whole records
  std::optional<mcap::Writer> writer_;
  std::uint16_t frames_ = 0, states_ = 0;
  std::array<std::uint16_t, 2> images_{};
  std::vector<std::byte> bytes_;
  std::chrono::steady_clock::time_point flushed_;
  bool is_dirty_ = false;
};

}  // namespace reorient
