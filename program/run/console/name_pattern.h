// SPDX-License-Identifier: MIT
// Names as a person picks them out of many.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Whether the whole name is as the pattern says, in which '*' stands for any letters.
bool matches(std::string_view pattern, std::string_view name);

/// The indices of the name that is `wanted`; else, where it holds a '*', of those that match; else of those that it is
/// a part of. Throws std::runtime_error with one line if no name matches; the message calls it a `kind` ("parameter").
std::vector<std::size_t> pick(std::string_view wanted, std::span<const std::string> names, std::string_view kind);

/// Others' bytes within a line of ours: on a terminal they must not be commands, and not fill it.
std::string printable(std::string_view text);

}  // namespace reorient
