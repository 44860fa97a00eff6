// SPDX-License-Identifier: MIT
#include "program/run/console/line_reader.h"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

#include <poll.h>
#include <unistd.h>

#include "program/terminal_guard.h"

namespace reorient {

bool has_input(int descriptor) {
  if (!is_in_foreground(descriptor)) return false;
  pollfd waiting{descriptor, POLLIN, 0};
  return ::poll(&waiting, 1, 0) == 1 && (waiting.revents & (POLLIN | POLLHUP)) != 0;
}

Typed LineReader::poll() {
  const bool closed = !ended_ && read_.find('\n') == std::string::npos && has_input(descriptor_) && read_some();
  return {take_line(), closed};
}

/// Whether the terminal was closed by Ctrl-D, which ends only one read.
bool LineReader::read_some() {
  std::array<char, 4096> buffer;
  const ssize_t count = read(descriptor_, buffer.data(), buffer.size());
  if (count > 0) {
    read_.append(buffer.data(), static_cast<std::size_t>(count));
  } else if (count == 0 && isatty(descriptor_) == 1) {
    return true;
  } else {
    ended_ = count == 0 || (errno != EAGAIN && errno != EINTR);
  }
  return false;
}

std::optional<std::string> LineReader::take_line() {
  const std::size_t end = read_.find('\n');
  const bool is_whole = end != std::string::npos;
  if (!is_whole && read_.size() > kLongestLine) {
    too_long_ = true;
    read_.clear();
  }
  if (!is_whole && (!ended_ || (read_.empty() && !too_long_))) return std::nullopt;
  std::string line = read_.substr(0, end);
  read_.erase(0, is_whole ? end + 1 : end);
  if (std::exchange(too_long_, false) || line.size() > kLongestLine)
    throw std::runtime_error("expected a line of at most " + std::to_string(kLongestLine) +
                             " bytes, found a longer one");
  if (line.find('\0') != std::string::npos) throw std::runtime_error("expected text, found a line with zero bytes");
  return line;
}

}  // namespace reorient
