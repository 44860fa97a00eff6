// SPDX-License-Identifier: MIT
// The types that a value of a script may have, as far as they are known.
#pragma once

#include <string>

namespace reorient {

/// A set of types that the value may have.
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

/// The types without nil, because a value that may be nil usually has another type when it is used.
constexpr ValueTypes unless_nil(ValueTypes types) { return types == kNil ? kNil : types & ~kNil; }

/// Text for messages: "number", "number or string".
std::string in_words(ValueTypes types);

/// "a number", "nil".
std::string with_article(ValueTypes types);

}  // namespace reorient
