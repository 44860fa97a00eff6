// SPDX-License-Identifier: MIT
// Selects names by patterns.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Whether the whole name matches the pattern, in which '*' matches any characters.
bool matches(std::string_view pattern, std::string_view name);

/// The index of the name equal to `wanted`; otherwise, if it contains a '*', of those that match; otherwise of those
/// that contain it. Throws std::runtime_error with one line if no name matches; the message calls it a `kind`
/// ("parameter").
std::vector<std::size_t> pick(std::string_view wanted, std::span<const std::string> names, std::string_view kind);

/// Foreign text on one line, shortened, so that it can neither control nor fill the terminal.
std::string printable(std::string_view text);

}  // namespace reorient
