// SPDX-License-Identifier: MIT
// The text of a Lua script as tokens, for whoever must know where something stands: Lua itself reports lines, no
// columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Both count from 1; 0: not known.
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
  int depth = 0;  ///< how many (, [ and { are open around it

  bool is(Kind wanted, std::string_view written) const { return kind == wanted && text == written; }
  bool is_symbol(std::string_view written) const { return is(Kind::symbol, written); }
  bool is_keyword(std::string_view written) const { return is(Kind::keyword, written); }
};

/// Without comments; the last one is of the kind `end`. Never fails: what is no Lua becomes symbols.
std::vector<LuaToken> lua_tokens(std::string_view text);

}  // namespace reorient
