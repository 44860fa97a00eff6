// SPDX-License-Identifier: MIT
// The tokens of a Lua script with their positions: Lua itself reports lines, but no
// columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Both count from 1; 0: unknown.
struct TextPosition {
  int line = 0;
  int column = 0;  ///< in bytes

  bool operator==(const TextPosition&) const = default;
};

inline bool is_before(TextPosition left, TextPosition right) {
  return left.line != right.line ? left.line < right.line : left.column < right.column;
}

struct LuaToken {
  enum class Kind { name, keyword, number, text, symbol, end };

  Kind kind = Kind::end;
  std::string text;  ///< a text without its quotes, escapes as they were written
  TextPosition position;
  int depth = 0;  ///< number of open (, [ and { around it

  bool is(Kind expected, std::string_view written) const { return kind == expected && text == written; }
  bool is_symbol(std::string_view written) const { return is(Kind::symbol, written); }
  bool is_keyword(std::string_view written) const { return is(Kind::keyword, written); }
};

/// Without comments; the last one has the kind `end`. Never fails: text that is not Lua becomes symbols.
std::vector<LuaToken> lua_tokens(std::string_view text);

}  // namespace reorient
