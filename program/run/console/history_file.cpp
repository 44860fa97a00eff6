// SPDX-License-Identifier: MIT
#include "program/run/console/history_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"
#include "program/run/console/line_reader.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

constexpr off_t kLargest = 64 * 1024;  // bytes that are read, from the end

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error("'" + file.string() + "': " + why);
}

/// The end of a plain file. Opened without following links and without waiting for a pipe.
std::string read_end(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 && errno == ENOENT) return {};
  if (descriptor < 0 && errno == ELOOP) fail(file, "expected a plain file, found a link");
  if (descriptor < 0) fail(file, "cannot be read: " + std::generic_category().message(errno));
  struct stat status {};
  const bool is_plain = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  std::string text(is_plain ? static_cast<std::size_t>(std::min(status.st_size, kLargest)) : 0, '\0');
  const off_t begin = std::max<off_t>(0, status.st_size - kLargest);
  const ssize_t count = is_plain ? pread(descriptor, text.data(), text.size(), begin) : 0;
  close(descriptor);
  if (!is_plain) fail(file, "expected a plain file, found another type of file");
  if (count < 0) fail(file, "cannot be read");
  text.resize(static_cast<std::size_t>(count));
  if (begin > 0) text.erase(0, text.find('\n'));  // a line that was cut
  return text;
}

bool is_typed(const std::string& line) {
  const auto is_control = [](unsigned char code) { return code < ' ' || code == 0x7F; };
  return !line.empty() && line.size() <= kLongestLine && std::none_of(line.begin(), line.end(), is_control) &&
         is_utf8(line);
}

void keep_latest(std::vector<std::string>& lines) {
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  if (lines.size() > kMostHistory) lines.erase(lines.begin(), lines.end() - kMostHistory);
}

}  // namespace

std::optional<std::filesystem::path> history_path() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  std::filesystem::path folder = state == nullptr ? "" : state;
  if (!folder.is_absolute() && home != nullptr) folder = std::filesystem::path(home) / ".local" / "state";
  if (!folder.is_absolute()) return std::nullopt;
  return folder / "reorient" / "history";
}

std::vector<std::string> read_history(const std::filesystem::path& file) {
  const std::string text = read_end(file);
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string line = text.substr(begin, end - begin);
    if (is_typed(line)) lines.push_back(std::move(line));
    begin = end + 1;
  }
  keep_latest(lines);
  return lines;
}

void append_history(const std::filesystem::path& file, const std::vector<std::string>& lines) {
  std::vector<std::string> all = read_history(file);
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(all), is_typed);
  keep_latest(all);
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  std::error_code error;
  // Readable by the user only, as the XDG Base Directory Specification requires.
  if (std::filesystem::create_directories(file.parent_path(), error))
    std::filesystem::permissions(file.parent_path(), std::filesystem::perms::owner_all, error);
  write_whole_file(file, text);
}

}  // namespace reorient
