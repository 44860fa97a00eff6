// SPDX-License-Identifier: MIT
// Limits of the process (ulimit) that the program cannot work within.
#pragma once

#include <string>

namespace reorient {

/// Why the stack is too small, in one line; empty: it is large enough. Too small a stack ends the program with a
/// signal.
std::string stack_shortage();

/// What a process without free memory expected and found, in one line.
const char* memory_shortage();

/// From now on, a failed allocation throws an exception whose text is memory_shortage().
void name_memory_shortage();

}  // namespace reorient
