// SPDX-License-Identifier: MIT
// Where the declarations of a script stand in its text. Lua does not say where a table was written.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/source/lua_tokens.h"

namespace reorient {

class SourceLocations {
 public:
  explicit SourceLocations(std::string_view text);

  /// The table of `state "name" { ... }` or the like, as far as it was written there and not made by a function.
  struct Table {
    TextPosition position;   ///< of the name
    std::size_t begin = 0;   ///< token after the opening brace; 0: the table is not there
    std::size_t end = 0;     ///< the closing brace
    std::size_t cursor = 0;  ///< transitions before it were asked for already
    std::size_t common_cursor = 0;
    int misses = 0;  ///< transitions that were not found: after some, searching on is not worth its time
  };

  /// `word`: state, behavior, scenario; `line`: where Lua called it.
  Table table(std::string_view word, std::string_view name, int line) const;

  /// Where the next transition of the table to `target` stands; nothing where it was not written there.
  std::optional<TextPosition> transition(Table& table, std::string_view target, bool common) const;

  TextPosition end_of(const Table& table) const;

  /// The first `key =` at or after a place and before another, anywhere within.
  std::optional<TextPosition> key(std::string_view key, TextPosition from, TextPosition to) const;

  /// Lua describes a syntax error by its line and the words "near 'token'"; 0: not known.
  int column_of_syntax_error(std::string_view message, int line) const;

 private:
  std::vector<LuaToken>::const_iterator first_from(TextPosition position) const;

  std::vector<LuaToken> tokens_;
  std::vector<std::size_t> closing_;  ///< per token: where the brace that opens there closes
};

/// Those of each file that a script is made of.
using PlacesOf = std::function<const SourceLocations&(const std::string& file)>;

}  // namespace reorient
