// SPDX-License-Identifier: MIT
#include "workbench/recording/recording_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "geometry/bytes.h"
#include "workbench/files/write_all.h"
#include "workbench/recording/packed_image.h"

namespace reorient {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;  // bytes; a larger message has its own chunk

std::runtime_error failure(const std::filesystem::path& file, int error) {
  return std::runtime_error(file.string() + ": the file cannot be written: " + std::strerror(error));
}

/// The state of the file that the path names; nothing: none.
std::optional<struct stat> named_by(const std::filesystem::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

bool is_same_file(const std::optional<struct stat>& one, const struct stat& other) {
  return one && one->st_dev == other.st_dev && one->st_ino == other.st_ino;
}

/// Locks the file, and empties it only then: a second process must not destroy a recording in progress. Several runs
/// may write the same device or pipe. A file system without locks is used without one.
void lock_and_empty(int descriptor, const std::filesystem::path& file) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) throw failure(file, errno);
  if (!S_ISREG(status.st_mode)) return;
  const bool is_locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  // Another process may have removed the file between the opening and the lock.
  if ((!is_locked && errno == EWOULDBLOCK) || !is_same_file(named_by(file), status))
    throw std::runtime_error(file.string() +
                             ": expected a file that no other process writes, found a recording in progress; name "
                             "another file");
  if (ftruncate(descriptor, 0) != 0) throw failure(file, errno);
}

int opened(const std::filesystem::path& file, RecordingFile::Existing existing) {
  const int only_new = existing == RecordingFile::Existing::stays ? O_EXCL : 0;
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | only_new, 0666);
  if (descriptor < 0) throw failure(file, errno);
  try {
    lock_and_empty(descriptor, file);
  } catch (...) {
    close(descriptor);
    throw;
  }
  return descriptor;
}

}  // namespace

RecordingFile::RecordingFile(const std::filesystem::path& file, const mcap::Texts& about, std::vector<ViewTopic> views,
                             Existing existing)
    : file_(file), descriptor_(opened(file, existing)), flushed_(std::chrono::steady_clock::now()) {
  try {
    const auto version = about.find("version");
    writer_.emplace([this](std::span<const std::byte> bytes) { write(bytes); },
                    "reorient " + (version == about.end() ? std::string() : version->second));
    mcap::Texts all = about;
    all[std::string(kFormat)] = std::to_string(kRecordingFormat);
    writer_->add_metadata("reorient", all);
    const std::uint16_t schema = writer_->add_schema(kOwnSchema, kOwnSchemaEncoding, kOwnSchemaText);
    states_ = writer_->add_channel(kStateTopic, kOwnEncoding, schema);
    for (std::size_t camera = 0; camera < images_.size(); ++camera)
      images_[camera] = writer_->add_channel(kImageTopics[camera], kOwnEncoding, schema);
    frames_ = writer_->add_channel(kFrameTopic, kOwnEncoding, schema);
    for (ViewTopic& view : views) views_.push_back({std::move(view), {}});
  } catch (...) {
    close(descriptor_);
    std::error_code failed;
    if (std::filesystem::is_regular_file(file_, failed)) std::filesystem::remove(file_, failed);
    throw;
  }
}

RecordingFile::~RecordingFile() { close(descriptor_); }

/// Writes all of the bytes or none, because a partial record would make later ones unreadable.
void RecordingFile::write(std::span<const std::byte> bytes) {
  is_dirty_ = true;
  if (!write_all(descriptor_, bytes)) {
    const int error = errno;
    is_full_ = error == ENOSPC || error == EDQUOT || error == EFBIG;
    cut_to(size_);
    throw failure(file_, error);
  }
  size_ += static_cast<off_t>(bytes.size());
}

void RecordingFile::cut_to(off_t size) {
  if (ftruncate(descriptor_, size) == 0) lseek(descriptor_, size, SEEK_SET);  // a failure here cannot be handled
  size_ = size;
}

/// Flushes, so that a power failure loses at most the last half second.
void RecordingFile::flush() {
  if (is_dirty_ && fdatasync(descriptor_) != 0 && errno != EINVAL) throw failure(file_, errno);  // EINVAL: a pipe
  is_dirty_ = false;
}

void RecordingFile::add(const FrameEntry& entry, std::span<const std::byte> state,
                        const std::array<ImageView, 2>& images, std::span<const ViewMessage> views) {
  const std::uint64_t time = nanoseconds(entry.time);
  const auto begin_own = [this] { own_.assign(sizeof(std::uint32_t), std::byte{}); };
  if (!state.empty()) {
    begin_own();
    own_.insert(own_.end(), state.begin(), state.end());
    add_own_message(states_, time);
  }
  for (std::size_t camera = 0; camera < images.size(); ++camera) {
    if (!entry.image_is_exact[camera]) continue;
    begin_own();
    pack_image(images[camera], own_);
    add_own_message(images_[camera], time);
  }
  for (const ViewMessage& view : views) add_message(channel_of(view.topic), view.time, view.data);
  // The frame comes last, after the messages that belong to it.
  begin_own();
  write_frame_entry(entry, own_);
  add_own_message(frames_, time);
}

void RecordingFile::add_own_message(std::uint16_t channel, std::uint64_t time) {
  std::vector<std::byte> length;
  ByteWriter{length}(static_cast<std::uint32_t>(own_.size() - sizeof(std::uint32_t)));
  std::copy(length.begin(), length.end(), own_.begin());
  add_message(channel, time, own_);
}

/// Writes a topic only with its first message, because viewers list all topics of a file.
std::uint16_t RecordingFile::channel_of(std::size_t view) {
  View& requested = views_.at(view);
  if (requested.channel) return *requested.channel;
  const ViewTopic& topic = requested.topic;
  std::uint16_t schema = 0;
  if (!topic.schema.empty()) {
    const auto known = schemas_.find(topic.schema);
    schema = known != schemas_.end() ? known->second
                                     : writer_->add_schema(topic.schema, topic.schema_encoding, topic.schema_text);
    schemas_.emplace(topic.schema, schema);
  }
  requested.channel = writer_->add_channel(topic.name, topic.encoding, schema,
                                           topic.lasts ? mcap::Texts{{std::string(kLasts), "true"}} : mcap::Texts{});
  return *requested.channel;
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

/// A full disk has no space for the last chunk, and sometimes not for the summary of the others. Then the summary
/// replaces some chunks.
void RecordingFile::finish() {
  if (is_finished_) return;
  std::exception_ptr failed;
  const auto attempt = [&](const auto& write) {
    try {
      write();
      return true;
    } catch (...) {
      if (!failed) failed = std::current_exception();
      return false;
    }
  };
  attempt([this] { writer_->close_chunk(); });
  is_finished_ = attempt([this] { writer_->finish(); });
  if (!is_finished_ && is_full_ && writer_->make_room()) {
    cut_to(static_cast<off_t>(writer_->size()));
    is_finished_ = attempt([this] { writer_->finish(); });
  }
  flush();
  if (failed) std::rethrow_exception(failed);
}

void RecordingFile::require_in_place() const {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) throw failure(file_, errno);
  const bool is_whole = !S_ISREG(status.st_mode) || status.st_size == size_;
  if (is_whole && is_same_file(named_by(file_), status)) return;
  throw std::runtime_error(file_.string() +
                           ": expected the recording of this run, found that another program removed, replaced or "
                           "changed the file");
}

int RecordingFile::share_lock() const { return fcntl(descriptor_, F_DUPFD_CLOEXEC, 0); }

}  // namespace reorient
