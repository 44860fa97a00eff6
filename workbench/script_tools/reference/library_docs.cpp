// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/library_docs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/parameters/utf8.h"
#include "engine/script/source/lua_tokens.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// The last line of a token. A text in long brackets may span several lines.
int last_line(const LuaToken& token) {
  return token.position.line + static_cast<int>(std::count(token.text.begin(), token.text.end(), '\n'));
}

class LibraryReader {
 public:
  explicit LibraryReader(std::string_view text)
      : lines_(lines_of(without_byte_order_mark(text))), tokens_(lua_tokens(text)) {}

  LibraryModule read() {
    for (std::size_t i = 0; at(i).kind != Kind::end; ++i) {
      if (blocks_ == 0 && at(i).depth == 0) read_statement(i);
      if (table_ && blocks_ == 0 && at(i).depth == 1) read_entry(i);
      if (table_ && at(i).is_symbol("}") && at(i).depth == 0) table_.reset();
      count_blocks(at(i));
    }
    LibraryModule module;
    module.description = description();
    module.members = std::move(tables_[returned_]);
    std::erase_if(module.members, [](const LibraryMember& member) { return member.name.starts_with('_'); });
    return module;
  }

 private:
  const LuaToken& at(std::size_t index) const { return tokens_[std::min(index, tokens_.size() - 1)]; }
  bool is_name(std::size_t index) const { return at(index).kind == Kind::name; }

  void count_blocks(const LuaToken& token) {
    for (const char* const word : {"function", "do", "if", "repeat"}) blocks_ += token.is_keyword(word) ? 1 : 0;
    for (const char* const word : {"end", "until"}) blocks_ -= token.is_keyword(word) ? 1 : 0;
    blocks_ = std::max(blocks_, 0);  // an unmatched `end`: not valid Lua
  }

  void read_statement(std::size_t i) {
    if (at(i).is_keyword("return")) {
      read_return(i);
    } else if (at(i).is_keyword("local")) {
      read_local(i);
    } else if (at(i).is_keyword("function") && is_name(i + 1) && is_name(i + 3) && at(i + 4).is_symbol("(")) {
      if (!at(i + 2).is_symbol(".") && !at(i + 2).is_symbol(":")) return;
      add(at(i + 1).text, function(at(i + 3).text, i, i + 4, at(i + 2).is_symbol(":")));
    } else if (is_name(i) && (i == 0 || (!at(i - 1).is_symbol(".") && !at(i - 1).is_symbol(":")))) {
      if (at(i + 1).is_symbol("=") && at(i + 2).is_symbol("{")) table_ = at(i).text;
      if (at(i + 1).is_symbol(".") && is_name(i + 2) && at(i + 3).is_symbol("="))
        add(at(i).text, value(at(i + 2).text, i, i + 4));
    }
  }

  void read_local(std::size_t i) {
    if (at(i + 1).is_keyword("function")) {
      if (is_name(i + 2) && at(i + 3).is_symbol("("))
        locals_[at(i + 2).text] = function(at(i + 2).text, i, i + 3, false);
      return;
    }
    const std::size_t equals = at(i + 2).is_symbol("<") ? i + 5 : i + 2;  // local name <const> =
    if (!is_name(i + 1) || !at(equals).is_symbol("=")) return;
    if (at(equals + 1).is_symbol("{")) table_ = at(i + 1).text;
    if (at(equals + 1).is_keyword("function")) locals_[at(i + 1).text] = value(at(i + 1).text, i, equals + 1);
  }

  /// `return module`, `return { ... }`, `return setmetatable(module, ...)`.
  void read_return(std::size_t i) {
    if (at(i + 1).is_symbol("{")) {
      returned_.clear();
      table_ = returned_;
    } else if (is_name(i + 1)) {
      returned_ = at(i + 2).is_symbol("(") && is_name(i + 3) ? at(i + 3).text : at(i + 1).text;
    }
  }

  /// Reads an entry of a table constructor.
  void read_entry(std::size_t i) {
    const bool begins = at(i - 1).is_symbol("{") || at(i - 1).is_symbol(",") || at(i - 1).is_symbol(";");
    if (begins && is_name(i) && at(i + 1).is_symbol("=")) add(*table_, value(at(i).text, i, i + 2));
  }

  void add(const std::string& table, LibraryMember member) {
    std::vector<LibraryMember>& members = tables_[table];
    const bool is_known = std::any_of(members.begin(), members.end(),
                                      [&](const LibraryMember& other) { return other.name == member.name; });
    if (!is_known) members.push_back(std::move(member));
  }

  /// `start`: the first token of its statement or entry. `list`: the bracket that opens its parameters.
  LibraryMember function(const std::string& name, std::size_t start, std::size_t list, bool is_method) {
    LibraryMember member{name, true, is_method, {}, doc_before(start)};
    for (std::size_t i = list + 1; is_name(i) || at(i).is_symbol("..."); i += 2) {
      member.parameters.push_back(at(i).text);
      if (!is_name(i) || !at(i + 1).is_symbol(",")) break;
    }
    return member;
  }

  /// `token`: the first token of the value.
  LibraryMember value(const std::string& name, std::size_t start, std::size_t token) {
    if (at(token).is_keyword("function")) return function(name, start, token + 1, false);
    const auto local = is_name(token) ? locals_.find(at(token).text) : locals_.end();
    const LuaToken& next = at(token + 1);
    const bool is_name_alone = next.depth <= at(token).depth && !next.is_symbol(".") && !next.is_symbol("(") &&
                               !next.is_symbol("[") && !next.is_symbol("{") && next.kind != Kind::text;
    if (local == locals_.end() || !is_name_alone) return {name, false, false, {}, doc_before(start)};
    LibraryMember member = local->second;
    member.name = name;
    if (DocComment own = doc_before(start); !own.lines.empty()) member.doc = std::move(own);
    return member;
  }

  const std::string_view& line(int number) const { return lines_[static_cast<std::size_t>(number - 1)]; }

  /// The comment in the lines directly above a token that is the first of its line. Only comments can be between two
  /// tokens.
  DocComment doc_before(std::size_t token) {
    const int before = token == 0 ? 0 : last_line(at(token - 1));
    int first = at(token).position.line;
    while (first - 1 > before && is_doc_line(line(first - 1))) --first;
    std::vector<std::string_view> lines;
    for (int i = first; i < at(token).position.line; ++i) lines.push_back(line(i));
    if (!lines.empty()) first_lines_.insert(first);
    return doc_comment(lines);
  }

  /// The first doc comment of the file, unless it belongs to a member. Only comments can be before the first token.
  std::string description() const {
    const auto first_token = lines_.begin() + std::min(std::ssize(lines_), std::ptrdiff_t{at(0).position.line - 1});
    const auto first = std::find_if(lines_.begin(), first_token, is_doc_line);
    if (first_lines_.contains(static_cast<int>(first - lines_.begin()) + 1)) return {};
    return doc_comment({first, std::find_if_not(first, lines_.end(), is_doc_line)}).description;
  }

  std::vector<std::string_view> lines_;
  std::vector<LuaToken> tokens_;
  int blocks_ = 0;                    ///< number of open blocks around the token: functions, loops, conditions
  std::optional<std::string> table_;  ///< table whose constructor is being read; empty: the returned one
  std::string returned_;              ///< name of the returned table
  std::map<std::string, std::vector<LibraryMember>> tables_;
  std::map<std::string, LibraryMember> locals_;  ///< local functions
  std::set<int> first_lines_;                    ///< of the comments of members
};

}  // namespace

LibraryModule library_module(std::string name, std::string_view text) {
  LibraryModule module = LibraryReader(text).read();
  module.name = std::move(name);
  return module;
}

std::vector<LibraryModule> library_modules(const ScriptTexts& texts) {
  std::vector<LibraryModule> modules;
  for (const std::string& file : texts.in_folder("lib")) {
    std::string name = file.substr(0, file.size() - std::string_view(".lua").size());
    std::replace(name.begin(), name.end(), '/', '.');
    if (module_file(name) != file) continue;  // no script can require it
    const ScriptText& text = *texts.find(file);
    modules.push_back(text.problem.empty() ? library_module(std::move(name), text.text)
                                           : LibraryModule{std::move(name), text.problem, {}});
  }
  return modules;
}

}  // namespace reorient
