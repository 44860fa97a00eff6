// SPDX-License-Identifier: MIT
// "Did you mean ...?", and what else there is.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace reorient {

/// How many letters must be inserted, removed, replaced or swapped with their neighbour (Damerau and Levenshtein).
int edit_distance(std::string_view left, std::string_view right);

/// The known name that looks most like `wanted`, if one is near enough to be a slip of the finger, or begins with it.
std::optional<std::string> nearest_name(std::string_view wanted, std::span<const std::string> known);

/// " (did you mean 'x'?)", or nothing.
std::string did_you_mean(std::string_view wanted, std::span<const std::string> known);

/// "a, b, c": the first dozen, and that there are more.
std::string list_of(std::span<const std::string> names);

}  // namespace reorient
