#include "workbench/recording/recording_file.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "workbench/recording/frame_entry.h"

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
  const std::size_t size = bytes.size();
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      if (ftruncate(descriptor_, size_) == 0) lseek(descriptor_, size_, SEEK_SET);  // what else could be done about it?
      throw failure(file_, error);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  size_ += static_cast<off_t>(size);
}

/// So that an empty battery takes no more than the last half second.
void RecordingFile::flush() {
  if (is_dirty_ && fdatasync(descriptor_) != 0 && errno != EINVAL) throw failure(file_, errno);  // EINVAL: a pipe
  is_dirty_ = false;
}

void RecordingFile::add(std::uint16_t channel, std::uint64_t time, std::span<const std::byte> data) {
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
