// SPDX-License-Identifier: MIT
#include "workbench/script_tools/graph/condition_fields.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "engine/script/language/world_fields.h"

namespace reorient {
namespace {

using Tokens = std::span<const LuaToken>;
using Kind = LuaToken::Kind;

/// From the `{` of the transition to the end of its brackets. The position of a transition is that of its target, which
/// follows the `{`. Empty: not found.
Tokens transition_at(Tokens tokens, TextPosition position) {
  const auto is_begin = [&](std::size_t i) {
    if (!tokens[i].is_symbol("{")) return false;
    if (position.column == 0) return tokens[i].position.line == position.line;
    return tokens[i].position == position || (i + 1 < tokens.size() && tokens[i + 1].position == position);
  };
  std::size_t begin = 0;
  while (begin < tokens.size() && !is_begin(begin)) ++begin;
  if (begin == tokens.size()) return {};
  std::size_t end = begin + 1;
  while (end < tokens.size() && tokens[end].depth > tokens[begin].depth) ++end;
  return tokens.subspan(begin, end - begin);
}

/// From the token with this index to the `end` below its beginning, or in the same line.
Tokens function_from(Tokens tokens, std::size_t index) {
  const TextPosition begin = tokens[index].position;
  const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(index);
  return {first, std::find_if(first, tokens.end(), [&](const LuaToken& token) {
            return token.is_keyword("end") &&
                   (token.position.column == begin.column || token.position.line == begin.line);
          })};
}

/// `local function NAME`, or `local NAME = function`. Empty: unknown.
Tokens local_function(Tokens tokens, const std::string& name) {
  for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
    if (!tokens[i].is_keyword("local")) continue;
    const bool is_named = tokens[i + 1].is_keyword("function") && tokens[i + 2].is(Kind::name, name);
    const bool is_value = tokens[i + 1].is(Kind::name, name) && tokens[i + 3].is_keyword("function");
    if (is_named || is_value) return function_from(tokens, i);
  }
  return {};
}

/// `function MODULE.NAME`, `MODULE.NAME = function`, or `NAME = function` in a table. Empty: unknown.
Tokens module_function(Tokens tokens, const std::string& name) {
  for (std::size_t i = 1; i + 2 < tokens.size(); ++i) {
    if (!tokens[i].is(Kind::name, name)) continue;
    const bool is_field = i >= 2 && tokens[i - 1].is_symbol(".");
    const bool is_value = tokens[i + 1].is_symbol("=") && tokens[i + 2].is_keyword("function");
    if (is_field && i >= 3 && tokens[i - 3].is_keyword("function")) return function_from(tokens, i - 3);
    if (is_value) return function_from(tokens, is_field ? i - 2 : i);
  }
  return {};
}

/// The files of `local NAME = require "..."`.
std::map<std::string, std::string> required_modules(Tokens tokens) {
  std::map<std::string, std::string> modules;
  for (std::size_t i = 0; i + 5 < tokens.size(); ++i) {
    if (!tokens[i].is_keyword("local") || tokens[i + 1].kind != Kind::name || !tokens[i + 2].is_symbol("=") ||
        !tokens[i + 3].is(Kind::name, "require"))
      continue;
    const LuaToken& module = tokens[tokens[i + 4].is_symbol("(") ? i + 5 : i + 4];
    if (module.kind != Kind::text) continue;
    if (const auto file = module_file(module.text)) modules[tokens[i + 1].text] = *file;
  }
  return modules;
}

/// "input.ball.x", which begins with the token at `i`.
std::string dotted_name(Tokens tokens, std::size_t i) {
  std::string name = tokens[i].text;
  for (; i + 2 < tokens.size() && tokens[i + 1].is_symbol(".") && tokens[i + 2].kind == Kind::name; i += 2)
    name.append(".").append(tokens[i + 2].text);
  return name;
}

const std::set<std::string>& known_fields() {
  static const std::set<std::string> all = [] {
    std::set<std::string> names;
    for (const WorldField& field : world_fields()) names.insert(field.full_name());
    return names;
  }();
  return all;
}

}  // namespace

/// Follows one condition.
class ConditionFields::Reader {
 public:
  explicit Reader(ConditionFields& fields) : fields_(fields) {}

  void read(const std::string& file, Tokens tokens) {
    const File& whole = fields_.read_file(file);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      if (tokens[i].kind != Kind::name || (i > 0 && tokens[i - 1].is_symbol("."))) continue;
      const bool has_field = i + 2 < tokens.size() && tokens[i + 1].is_symbol(".");
      const std::string& first = tokens[i].text;
      if (first == "input" || first == "action") {
        add(dotted_name(tokens, i));
        continue;
      }
      const std::string name = has_field ? first + "." + tokens[i + 2].text : first;
      if (!seen_.insert({file, name}).second) continue;
      const auto module = has_field ? whole.modules.find(first) : whole.modules.end();
      if (module != whole.modules.end()) {
        read(module->second, module_function(fields_.read_file(module->second).tokens, tokens[i + 2].text));
      } else if (known_fields().contains(name)) {
        add(name);
      } else if (has_field) {
        read_own_module(file, first, tokens[i + 2].text);
      } else {
        read(file, local_function(whole.tokens, name));
      }
    }
  }

  std::vector<std::string> found;

 private:
  void add(const std::string& name) {
    if (std::find(found.begin(), found.end(), name) == found.end()) found.push_back(name);
  }

  /// A function of a library that calls another one of the same library, as `module.name`.
  void read_own_module(const std::string& file, const std::string& table, const std::string& name) {
    if (!file.starts_with("lib/")) return;
    const std::vector<LuaToken>& tokens = fields_.read_file(file).tokens;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      if (tokens[i].is_keyword("return") && tokens[i + 1].is(Kind::name, table) && tokens[i].depth == 0 &&
          tokens[i].position.column == 1)
        return read(file, module_function(tokens, name));
    }
  }

  ConditionFields& fields_;
  std::set<std::pair<std::string, std::string>> seen_;  ///< file and name
};

const ConditionFields::File& ConditionFields::read_file(const std::string& name) {
  const auto [found, is_new] = files_.try_emplace(name);
  if (is_new) {
    if (const ScriptText* const text = texts_.find(name)) found->second.tokens = lua_tokens(text->text);
    found->second.modules = required_modules(found->second.tokens);
  }
  return found->second;
}

std::vector<std::string> ConditionFields::read_at(const std::string& file, TextPosition begin) {
  Reader reader(*this);
  reader.read(file, transition_at(read_file(file).tokens, begin));
  return reader.found;
}

}  // namespace reorient
