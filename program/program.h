// SPDX-License-Identifier: MIT
// The reorient program as a function, which tests call, too.
#pragma once

#include <iosfwd>

namespace reorient {

/// Exit codes.
inline constexpr int kSuccess = 0;
inline constexpr int kWrong = 1;     ///< the robot ended wrong, or a test failed
inline constexpr int kBadInput = 2;  ///< one line on `err`: where, what was expected, what was found

int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& err);

}  // namespace reorient
