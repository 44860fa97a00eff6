// SPDX-License-Identifier: MIT
#include "workbench/files/input_file.h"

#include <algorithm>
#include <cerrno>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

/// Whole units, rounded up, so that no file that is too large seems to be within the limit.
std::string size_text(std::uintmax_t bytes) {
  constexpr std::uintmax_t kKiB = 1024, kMiB = 1024 * kKiB;
  if (bytes % kMiB == 0 || bytes > 10 * kMiB) return std::to_string((bytes + kMiB - 1) / kMiB) + " MiB";
  return std::to_string((bytes + kKiB - 1) / kKiB) + " KiB";
}

/// What lies there instead of an open file.
std::string why_not_open(const std::filesystem::path& file, int error) {
  std::error_code ignored;
  if (error == ENOENT && std::filesystem::is_symlink(file, ignored)) return "a link to a missing file";
  if (error == ENOENT) return "none";
  return "one that cannot be read: " + std::generic_category().message(error);
}

/// The bytes that can be read, one more than `most` at most. Fails with errno.
bool read_all(int descriptor, std::uintmax_t most, std::string& bytes) {
  // The size of the file, if it is known, and one more to find the end.
  while (bytes.size() <= most) {
    constexpr std::uintmax_t kLeast = 64 * 1024;
    const std::size_t begin = bytes.size();
    struct stat status {};
    const bool is_known = begin == 0 && fstat(descriptor, &status) == 0 && status.st_size > 0;
    const std::uintmax_t piece = is_known ? static_cast<std::uintmax_t>(status.st_size) + 1 : kLeast;
    bytes.resize(begin + static_cast<std::size_t>(std::min(piece, most + 1 - begin)));
    const ssize_t count = ::read(descriptor, bytes.data() + begin, bytes.size() - begin);
    bytes.resize(begin + static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
  }
  return true;
}

/// Why the file is refused; nothing: `bytes` are its content.
std::optional<std::string> read_plain(int descriptor, std::uintmax_t most, std::string& bytes) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return "one that cannot be read: " + std::generic_category().message(errno);
  if (S_ISDIR(status.st_mode)) return "a folder";
  if (!S_ISREG(status.st_mode)) return "another type of file";
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > most) return "a larger one (" + size_text(size) + ")";
  try {
    if (!read_all(descriptor, most, bytes)) return "one that cannot be read: " + std::generic_category().message(errno);
  } catch (const std::bad_alloc&) {
    return "too little memory for its " + size_text(size);
  }
  if (bytes.size() > most) return "a larger one";
  return std::nullopt;
}

}  // namespace

std::string read_input(const std::filesystem::path& file, const std::string& what, std::uintmax_t most) {
  // A pipe is opened without waiting for its writer.
  const int descriptor = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  const int error = errno;
  std::string bytes;
  std::optional<std::string> found = descriptor < 0 ? why_not_open(file, error) : read_plain(descriptor, most, bytes);
  if (descriptor >= 0) close(descriptor);
  if (!found) return bytes;
  const std::string limit = found->starts_with("a larger") ? " of at most " + size_text(most) : "";
  throw std::runtime_error("expected " + what + limit + ", found " + *found);
}

std::string read_named_input(const std::filesystem::path& file, const std::string& what, std::uintmax_t most) try {
  return read_input(file, what, most);
} catch (const std::runtime_error& reason) {
  throw std::runtime_error(as_line(file.string() + ": " + reason.what()));
}

}  // namespace reorient
