// SPDX-License-Identifier: MIT
#include "engine/script/source/source_locations.h"

#include <algorithm>

namespace reorient {

using Kind = LuaToken::Kind;

SourceLocations::SourceLocations(std::string_view text)
    : tokens_(lua_tokens(text)), closing_(tokens_.size(), tokens_.size() - 1) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (tokens_[i].is_symbol("{")) open.push_back(i);
    if (!tokens_[i].is_symbol("}") || open.empty()) continue;
    closing_[open.back()] = i;
    open.pop_back();
  }
}

std::vector<LuaToken>::const_iterator SourceLocations::first_from(TextPosition position) const {
  return std::lower_bound(tokens_.begin(), tokens_.end(), position,
                          [](const LuaToken& token, TextPosition from) { return is_before(token.position, from); });
}

SourceLocations::Table SourceLocations::table(std::string_view word, std::string_view name, int line) const {
  const auto first = static_cast<std::size_t>(first_from({line, 0}) - tokens_.begin());
  for (std::size_t i = first; i + 2 < tokens_.size() && tokens_[i].position.line == line; ++i) {
    if (!tokens_[i].is(Kind::name, word)) continue;
    if (!tokens_[i + 1].is(Kind::text, name)) continue;
    Table found{tokens_[i + 1].position};
    if (!tokens_[i + 2].is_symbol("{")) return found;
    found.begin = i + 3;
    found.end = closing_[i + 2];
    found.cursor = found.begin;
    for (std::size_t j = found.begin; j + 2 < found.end; ++j) {
      const bool is_common = tokens_[j].is(Kind::name, "common") && tokens_[j].depth == tokens_[i + 2].depth + 1;
      if (is_common && tokens_[j + 1].is_symbol("=") && tokens_[j + 2].is_symbol("{")) found.common_cursor = j + 3;
    }
    return found;
  }
  return {{line, 0}};
}

std::optional<TextPosition> SourceLocations::transition(Table& table, std::string_view target, bool common) const {
  std::size_t& cursor = common ? table.common_cursor : table.cursor;
  constexpr int kMostMisses = 8;
  if (table.begin == 0 || cursor == 0 || table.misses > kMostMisses) return std::nullopt;
  // A transition's brace is in the state's own table, that of a `common` one is one table deeper.
  const int depth = tokens_[table.begin - 1].depth + (common ? 2 : 1);
  for (std::size_t i = cursor; i + 2 < table.end; ++i) {
    const LuaToken& after = tokens_[i + 2];
    const bool ends = after.is_symbol(",") || after.is_symbol(";") || after.is_symbol("}");
    if (!tokens_[i].is_symbol("{") || tokens_[i].depth != depth || !tokens_[i + 1].is(Kind::text, target) || !ends)
      continue;
    cursor = i + 1;
    return tokens_[i + 1].position;
  }
  ++table.misses;
  return std::nullopt;
}

TextPosition SourceLocations::end_of(const Table& table) const {
  return table.begin == 0 ? table.position : tokens_[table.end].position;
}

std::optional<TextPosition> SourceLocations::key(std::string_view key, TextPosition from, TextPosition to) const {
  for (auto token = first_from(from); token + 1 < tokens_.end() && is_before(token->position, to); ++token) {
    if (token->is(Kind::name, key) && (token + 1)->is_symbol("=")) return token->position;
  }
  return std::nullopt;
}

int SourceLocations::column_of_syntax_error(std::string_view message, int line) const {
  constexpr std::string_view kNear = "near '";
  const std::size_t begin = message.rfind(kNear);
  if (begin == std::string_view::npos || !message.ends_with('\'')) return 0;
  message.remove_prefix(begin + kNear.size());
  message.remove_suffix(1);
  for (auto token = first_from({line, 0}); token < tokens_.end() && token->position.line == line; ++token) {
    if (token->text == message) return token->position.column;
  }
  return 0;
}

}  // namespace reorient
