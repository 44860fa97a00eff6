// SPDX-License-Identifier: MIT
// A word of a command line, quoted for a shell.
#pragma once

#include <string>

namespace reorient {

/// In quotes if necessary. One line, also for a word with line ends.
std::string shell_word(const std::string& word);

}  // namespace reorient
