#include "workbench/recording/recording_file.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "workbench/files/write_all.h"
#include "workbench/recording/packed_image.h"

namespace reorient {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;  // bytes; a larger message has a chunk of its own

std::runtime_error failure(const std::filesystem::path& file, int error) {
  return std::runtime_error(file.string() + ": it cannot be written: " + std::strerror(error));
}

}  // namespace

RecordingFile::RecordingFile(const std::filesystem::path& file, const mcap::Texts& about)
    : file_(file),
      descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
      flushed_(std::chrono::steady_clock::now()) {
  if (descriptor_ < 0) throw failure(file, errno);
  try {
    const auto version = about.find("version");
    writer_.emplace([this](std::span<const std::byte> bytes) { write(bytes); },
                    "reorient " + (version == about.end() ? std::string() : version->second));
    writer_->add_metadata("reorient", about);
    states_ = writer_->add_channel(kStateTopic, kOwnEncoding, 0);
    for (std::size_t camera = 0; camera < images_.size(); ++camera)
      images_[camera] = writer_->add_channel(kImageTopics[camera], kOwnEncoding, 0);
    frames_ = writer_->add_channel(kFrameTopic, kOwnEncoding, 0);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

RecordingFile::~RecordingFile() { close(descriptor_); }

/// All of it or nothing: half a record would hide what comes after it.
void RecordingFile::write(std::span<const std::byte> bytes) {
  is_dirty_ = true;
  if (!write_all(descriptor_, bytes)) {
    const int error = errno;
    if (ftruncate(descriptor_, size_) == 0) lseek(descriptor_, size_, SEEK_SET);  // what else could be done about it?
    throw failure(file_, error);
  }
  size_ += static_cast<off_t>(bytes.size());
}

/// So that an empty battery takes no more than the last half second.
void RecordingFile::flush() {
  if (is_dirty_ && fdatasync(descriptor_) != 0 && errno != EINVAL) throw failure(file_, errno);  // EINVAL: a pipe
  is_dirty_ = false;
}

void RecordingFile::add(const FrameEntry& entry, std::span<const std::byte> state,
                        const std::array<ImageView, 2>& images) {
  const std::uint64_t time = nanoseconds(entry.time);
  if (!state.empty()) add_message(states_, time, state);
  for (std::size_t camera = 0; camera < images.size(); ++camera) {
    if (!entry.image_is_exact[camera]) continue;
    bytes_.clear();
    pack_image(images[camera], bytes_);
    add_message(images_[camera], time, bytes_);
  }
  bytes_.clear();
  write_frame_entry(entry, bytes_);
  add_message(frames_, time, bytes_);
}

void RecordingFile::add_message(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data) {
  if (writer_->waiting() > 0 && writer_->waiting() + data.size() > kChunk) writer_->close_chunk();
  writer_->add_message(channel, time, data);
}

void RecordingFile::keep_up() {
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < kFlushEvery) return;
  flushed_ = now;
  writer_->close_chunk();
  flush();
}

/// A full disk has no room for the last chunk, but the more for the summary of all others.
void RecordingFile::finish() {
  std::exception_ptr failed;
  try {
    writer_->close_chunk();
  } catch (...) {
    failed = std::current_exception();
  }
  writer_->finish();
  flush();
  if (failed) std::rethrow_exception(failed);
}

}  // namespace reorient
