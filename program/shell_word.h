// SPDX-License-Identifier: MIT
// A word of a command line, as a shell takes it.
#pragma once

#include <string>

namespace reorient {

/// In quotes where it has to be.
std::string shell_word(const std::string& word);

}  // namespace reorient
