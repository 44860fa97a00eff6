// SPDX-License-Identifier: MIT
// Limits of one script. They do not depend on the clock, so a script behaves the same on a slow computer.
#pragma once

#include "geometry/const_or.h"

namespace reorient {

struct ScriptLimits {
  int instructions_per_frame = 50'000;
  int instructions_per_load = 2'000'000;
  int max_memory = 1024;     // KiB
  int string_length = 4096;  // bytes
  int max_errors = 5;
  double error_window = 10.0;  // s
  double trial_time = 2.0;     // s
};

inline constexpr ScriptLimits kDefaultLimits{};

template <ConstOr<ScriptLimits> T, typename Visit>
void describe(T& limits, Visit&& visit) {
  visit("instructions_per_frame", limits.instructions_per_frame, 1000, 100'000'000, "",
        "largest number of Lua instructions of a script in one frame");
  visit("instructions_per_load", limits.instructions_per_load, 1000, 1'000'000'000, "",
        "largest number of Lua instructions of a script while it is loaded");
  visit("max_memory", limits.max_memory, 256, 1'048'576, "KiB", "largest memory of a script");
  visit("string_length", limits.string_length, 256, 16'777'216, "byte", "largest length of a string in a script");
  visit("max_errors", limits.max_errors, 1, 1000, "",
        "number of run-time errors after which a script is rolled back or stopped");
  visit("error_window", limits.error_window, 0.1, 3600.0, "s",
        "time without an error after which earlier errors no longer count");
  visit("trial_time", limits.trial_time, 0.0, 3600.0, "s",
        "time without an error after which a version counts as good");
}
template <typename Visit, ConstOr<ScriptLimits> T>
void fields(Visit&& visit, T& limits) {
  describe(limits, [&](const char*, auto& value, const auto&...) { visit(value); });
}

}  // namespace reorient
