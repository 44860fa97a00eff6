// SPDX-License-Identifier: MIT
// Converts arbitrary bytes of scripts, file names and input to valid UTF-8 for output files.
#pragma once

#include <string>
#include <string_view>

namespace reorient {

bool is_utf8(std::string_view text);

/// The text with each byte that is not valid UTF-8 escaped, as in "\xFF".
std::string as_utf8(std::string_view text);

/// The same on one line for a terminal: line ends and tabs become spaces, other control characters
/// are escaped.
std::string as_line(std::string_view text);

/// as_line() for each line: line ends, tabs and spaces stay.
std::string as_text(std::string_view text);

/// The text without the byte order mark with which editors on Windows begin a file.
std::string_view without_byte_order_mark(std::string_view text);

/// "\x1B" for each byte.
std::string written_out(std::string_view bytes);

}  // namespace reorient
