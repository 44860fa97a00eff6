// SPDX-License-Identifier: MIT
// Positions of declarations in a script's text, because Lua does not report the positions of tables.
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

  /// The table of `state "name" { ... }` or similar, if it was written in place and not made by a function.
  struct Table {
    TextPosition position;   ///< of the name
    std::size_t begin = 0;   ///< token after the opening brace; 0: table not found
    std::size_t end = 0;     ///< the closing brace
    std::size_t cursor = 0;  ///< transitions before it were already found
    std::size_t common_cursor = 0;
    int misses = 0;  ///< transitions that were not found; after some the search stops
  };

  /// `word`: state, behavior, scenario; `line`: where Lua called it.
  Table table(std::string_view word, std::string_view name, int line) const;

  /// Position of the table's next transition to `target`; nothing if it was not written there.
  std::optional<TextPosition> transition(Table& table, std::string_view target, bool common) const;

  TextPosition end_of(const Table& table) const;

  /// The first `key =` between two positions at any depth.
  std::optional<TextPosition> key(std::string_view key, TextPosition from, TextPosition to) const;

  /// Lua describes a syntax error by its line and the words "near 'token'"; 0: unknown.
  int column_of_syntax_error(std::string_view message, int line) const;

 private:
  std::vector<LuaToken>::const_iterator first_from(TextPosition position) const;

  std::vector<LuaToken> tokens_;
  std::vector<std::size_t> closing_;  ///< per token: index of the brace that closes it
};

/// The locations of each file of a script.
using PlacesOf = std::function<const SourceLocations&(const std::string& file)>;

}  // namespace reorient
