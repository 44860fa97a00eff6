// SPDX-License-Identifier: MIT
#include "program/run/console/condition_values.h"

#include <algorithm>
#include <set>
#include <span>

#include "engine/script/language/world_fields.h"
#include "engine/script/source/lua_tokens.h"

namespace reorient {
namespace {

using Tokens = std::span<const LuaToken>;

/// From the first token of the line to the end of the brackets that it opens.
Tokens transition_at(Tokens tokens, int line) {
  const auto begin = std::find_if(tokens.begin(), tokens.end(), [line](const auto& token) {
    return token.position.line == line && token.is_symbol("{");
  });
  if (begin == tokens.end()) return {};
  const auto end =
      std::find_if(begin + 1, tokens.end(), [&](const auto& token) { return token.depth <= begin->depth; });
  return {begin, end};
}

/// From `local function NAME`, or `local NAME = function`, to the `end` below its beginning. Empty: unknown.
Tokens local_function(Tokens tokens, const std::string& name) {
  for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
    if (!tokens[i].is_keyword("local")) continue;
    const bool is_named = tokens[i + 1].is_keyword("function") && tokens[i + 2].is(LuaToken::Kind::name, name);
    const bool is_value = tokens[i + 1].is(LuaToken::Kind::name, name) && tokens[i + 3].is_keyword("function");
    if (!is_named && !is_value) continue;
    const TextPosition begin = tokens[i].position;
    const auto end =
        std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(), [&](const auto& token) {
          return token.is_keyword("end") &&
                 (token.position.column == begin.column || token.position.line == begin.line);
        });
    return {tokens.begin() + static_cast<std::ptrdiff_t>(i), end};
  }
  return {};
}

class FieldReader {
 public:
  explicit FieldReader(Tokens script) : script_(script) {
    for (const WorldField& field : world_fields()) known_.insert(field.full_name());
  }

  void read(Tokens tokens) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].kind != LuaToken::Kind::name || (i > 0 && tokens[i - 1].is_symbol("."))) continue;
      const bool has_field = i + 2 < tokens.size() && tokens[i + 1].is_symbol(".");
      const std::string name = has_field ? tokens[i].text + "." + tokens[i + 2].text : tokens[i].text;
      if (!seen_.insert(name).second) continue;
      if (known_.contains(name)) fields.push_back(name);
      if (!has_field) read(local_function(script_, name));
    }
  }

  std::vector<std::string> fields;

 private:
  Tokens script_;
  std::set<std::string> known_;
  std::set<std::string> seen_;
};

}  // namespace

std::vector<std::string> fields_read_at(std::string_view script, int line) {
  const std::vector<LuaToken> tokens = lua_tokens(script);
  FieldReader reader(tokens);
  reader.read(transition_at(tokens, line));
  return reader.fields;
}

}  // namespace reorient
