// SPDX-License-Identifier: MIT
// "Did you mean ...?", and lists of names for messages.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace reorient {

/// Number of letters to insert, remove, replace or swap with an adjacent letter (Damerau and Levenshtein).
int edit_distance(std::string_view left, std::string_view right);

/// The known name nearest to `text`, if it is near enough for a typing error or begins with `text`.
std::optional<std::string> nearest_name(std::string_view text, std::span<const std::string> known);

/// " (did you mean 'x'?)", or nothing.
std::string did_you_mean(std::string_view text, std::span<const std::string> known);

/// "a, b, c, ...": at most the first twelve.
std::string list_of(std::span<const std::string> names);

}  // namespace reorient
