// SPDX-License-Identifier: MIT
#include "workbench/recording/mcap/source.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace reorient::mcap {
namespace {

std::string failed(const std::filesystem::path& file) {
  return file.string() + ": it cannot be read: " + std::strerror(errno);
}

}  // namespace

Damage::Damage(std::uint64_t place, const std::string& what)
    : std::runtime_error("at byte " + std::to_string(place) + ": " + what), where(place) {}

FileSource::FileSource(const std::filesystem::path& file)
    : file_(file), descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) throw std::runtime_error(failed(file));
  if (!S_ISREG(status.st_mode)) {
    close(descriptor_);
    throw std::runtime_error(file.string() + ": expected a recording, found something that is not a file");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

FileSource::~FileSource() { close(descriptor_); }

void FileSource::read(std::uint64_t from, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(from));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw std::runtime_error(failed(file_));
    if (got == 0) throw std::runtime_error(file_.string() + ": the file became shorter while it was read");
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    from += static_cast<std::uint64_t>(got);
  }
}

void MemorySource::read(std::uint64_t from, std::span<std::byte> bytes) const {
  if (!bytes.empty()) std::memcpy(bytes.data(), bytes_.data() + from, bytes.size());
}

}  // namespace reorient::mcap
