// SPDX-License-Identifier: MIT
// Scripts, file names and people may hold any bytes; files that others read may not.
#pragma once

#include <string>
#include <string_view>

namespace reorient {

bool is_utf8(std::string_view text);

/// The text with each byte that is not part of valid UTF-8 written out, as in "\xFF".
std::string as_utf8(std::string_view text);

/// The same on one line that a terminal shows as it stands: line ends and tabs as blanks, other control characters
/// written out.
std::string as_line(std::string_view text);

/// "\x1B" for each byte.
std::string written_out(std::string_view bytes);

}  // namespace reorient
