// SPDX-License-Identifier: MIT
// Which types a value of a script may have, as far as that is known.
#pragma once

#include <string>

namespace reorient {

/// A set of these: several where it may be one or another.
using ValueTypes = unsigned;

inline constexpr ValueTypes kNil = 1;
inline constexpr ValueTypes kFalse = 2;
inline constexpr ValueTypes kTrue = 4;
inline constexpr ValueTypes kBoolean = kFalse | kTrue;
inline constexpr ValueTypes kNumber = 8;
inline constexpr ValueTypes kString = 16;
inline constexpr ValueTypes kTable = 32;
inline constexpr ValueTypes kFunction = 64;
inline constexpr ValueTypes kAnything = 127;
inline constexpr ValueTypes kFalsy = kNil | kFalse;

/// What is there besides nil: what is nil for a moment is mostly something else when it counts.
constexpr ValueTypes unless_nil(ValueTypes types) { return types == kNil ? kNil : types & ~kNil; }

/// "number", "number or string", as messages say it.
std::string in_words(ValueTypes types);

/// "a number", "nil".
std::string with_article(ValueTypes types);

}  // namespace reorient
