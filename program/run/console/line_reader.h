// SPDX-License-Identifier: MIT
// Lines from a pipe, a file, or a terminal that edits them itself.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace reorient {

/// Largest length of a command in bytes.
inline constexpr std::size_t kLongestLine = 1000;

/// The input since the last call.
struct Typed {
  std::optional<std::string> line;  ///< nothing: no complete line yet
  bool closed = false;              ///< of a terminal: by Ctrl-D on an empty line
};

/// Reads from a file descriptor without blocking, and a small part at a time, so that much input does not delay the
/// robot.
class LineReader {
 public:
  explicit LineReader(int descriptor) : descriptor_(descriptor) {}

  /// The next line. At the end of the input, the text after the last line break is a line, too.
  Typed poll();

 private:
  bool read_some();
  std::optional<std::string> take_line();

  int descriptor_;
  std::string read_;       ///< read, but not yet returned
  bool too_long_ = false;  ///< the rest of a line without an end is dropped
  bool ended_ = false;     ///< at the end of the input
};

/// Whether a read would not block; false for a terminal that another process group uses now.
bool has_input(int descriptor);

}  // namespace reorient
