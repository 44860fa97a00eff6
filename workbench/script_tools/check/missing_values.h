// SPDX-License-Identifier: MIT
// The values and actions of an application that a script uses, although the run does not declare them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/source/lua_tokens.h"
#include "robots/application.h"

namespace reorient {

struct MissingValue {
  std::string name;                     ///< "input.ball.seen" or "action.kick"
  TextPosition position;                ///< of its first use in the text
  std::vector<std::string> interfaces;  ///< names of those that declare it
};

/// In the order of the text, each once. Names that no interface declares and names that are built at run time are not
/// found. Never fails: unusual text gives fewer names.
std::vector<MissingValue> missing_values(std::string_view text, const ApplicationInterface& declared,
                                         std::span<const ApplicationInterface> known);

/// "input.ball.seen and 2 more are missing; the interface 'ball' has them". `missing` must not be empty.
std::string to_text(std::span<const MissingValue> missing);

}  // namespace reorient
