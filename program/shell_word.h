// SPDX-License-Identifier: MIT
// A word of a command line, quoted for a shell.
#pragma once

#include <string>

namespace reorient {

/// In quotes if necessary.
std::string shell_word(const std::string& word);

}  // namespace reorient
