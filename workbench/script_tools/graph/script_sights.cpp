#include "workbench/script_tools/graph/script_sights.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/script/source/lua_tokens.h"

namespace reorient {
namespace {

using Kind = LuaToken::Kind;

/// A local name's or a library member's definition: "name", or "module.name".
struct Reference {
  std::string file;
  std::string name;

  bool operator<(const Reference& other) const { return std::tie(file, name) < std::tie(other.file, other.name); }
};

/// What a stretch of a script looks at, and which definitions it names.
struct Passage {
  std::set<Sight> sights;
  std::set<Reference> references;

  void add(const Passage& other) {
    sights.insert(other.sights.begin(), other.sights.end());
    references.insert(other.references.begin(), other.references.end());
  }
};

/// One file: its tokens, and what its outermost statements define.
class ScriptSource {
 public:
  ScriptSource(std::string file, std::string_view text) : file_(std::move(file)), tokens_(lua_tokens(text)) {
    std::size_t begin = 0;
    int blocks = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (blocks == 0 && tokens_[i].depth == 0 && begins_statement(i)) {
        read_statement(begin, i);
        begin = i;
      }
      for (const char* const word : {"function", "do", "if", "repeat"}) blocks += tokens_[i].is_keyword(word) ? 1 : 0;
      for (const char* const word : {"end", "until"}) blocks -= tokens_[i].is_keyword(word) ? 1 : 0;
    }
  }

  const std::vector<LuaToken>& tokens() const { return tokens_; }
  /// What a name stands for: a passage between two tokens.
  struct Definition {
    Passage passage;
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  /// nullptr: the file does not define it.
  const Definition* find(const std::string& name) const {
    const auto found = definitions_.find(name);
    return found == definitions_.end() ? nullptr : &found->second;
  }

  /// Of the token alone: a name and what follows it.
  Passage look_at(std::size_t i) const {
    Passage passage;
    const bool is_field = i > 0 && (tokens_[i - 1].is_symbol(".") || tokens_[i - 1].is_symbol(":"));
    if (tokens_[i].kind != Kind::name || is_field) return passage;
    const std::string& name = tokens_[i].text;
    const std::string field = field_at(i + 1);
    if (name == "published") {
      if (!field.empty()) passage.sights.insert({"", field, ""});
    } else if (name == "behaviors") {
      if (!field.empty()) passage.sights.insert(machine_sight(i, field));
    } else if (const auto module = modules_.find(name); module != modules_.end()) {
      passage.references.insert({module->second, "module." + field});
    } else {
      passage.references.insert({file_, name});
      if (!field.empty()) passage.references.insert({file_, "module." + field});
    }
    return passage;
  }

 private:
  const LuaToken& at(std::size_t index) const { return tokens_[std::min(index, tokens_.size() - 1)]; }

  /// "name" of .name or ["name"] that begins there; empty: it is something else.
  std::string field_at(std::size_t i) const {
    if (at(i).is_symbol(".") && at(i + 1).kind == Kind::name) return at(i + 1).text;
    if (at(i).is_symbol("[") && at(i + 1).kind == Kind::text && at(i + 2).is_symbol("]")) return at(i + 1).text;
    return {};
  }

  static bool compares(const LuaToken& token) { return token.is_symbol("==") || token.is_symbol("~="); }

  /// behaviors.NAME.state == "text", of which either side may be the text.
  Sight machine_sight(std::size_t i, const std::string& machine) const {
    const std::size_t rest = i + (at(i + 1).is_symbol(".") ? 3 : 4);
    Sight sight{machine, field_at(rest), ""};
    const std::size_t behind = rest + (at(rest).is_symbol(".") ? 2 : 3);
    if (sight.field != "state") return sight;
    if (compares(at(behind)) && at(behind + 1).kind == Kind::text) {
      sight.state = at(behind + 1).text;
    } else if (i >= 2 && compares(at(i - 1)) && at(i - 2).kind == Kind::text) {
      sight.state = at(i - 2).text;
    }
    return sight;
  }

  /// An expression ends with the token before, and one does not go on with this.
  bool begins_statement(std::size_t i) const {
    if (i == 0) return false;
    const LuaToken& before = tokens_[i - 1];
    const LuaToken& token = tokens_[i];
    if (before.is_symbol(";") || token.kind == Kind::end) return true;
    const bool is_over = before.kind == Kind::name || before.kind == Kind::number || before.kind == Kind::text ||
                         before.is_symbol(")") || before.is_symbol("]") || before.is_symbol("}") ||
                         before.is_symbol("...") || before.is_keyword("end") || before.is_keyword("nil") ||
                         before.is_keyword("true") || before.is_keyword("false");
    const bool goes_on = token.is_keyword("and") || token.is_keyword("or");
    return is_over && (token.kind == Kind::name || (token.kind == Kind::keyword && !goes_on));
  }

  void read_statement(std::size_t begin, std::size_t end) {
    std::vector<std::string> names = defined_names(begin);
    if (names.empty()) return;
    if (at(begin + 2).is_symbol("=") && at(begin + 3).text == "require") {
      const LuaToken& argument = at(begin + (at(begin + 4).is_symbol("(") ? 5 : 4));
      if (const auto required = module_file(argument.text)) modules_[names.front()] = *required;
      return;
    }
    Passage passage;
    for (std::size_t i = begin; i < end; ++i) passage.add(look_at(i));
    for (const std::string& name : names) {
      Definition& definition = definitions_[name];
      definition.passage.add(passage);
      definition.begin = begin;
      definition.end = end;
    }
  }

  /// Of `local a, b = ...`, `local function a`, `function m.a`, `m.a = ...`, `a = ...`.
  std::vector<std::string> defined_names(std::size_t i) const {
    std::vector<std::string> names;
    if (at(i).is_keyword("local") && !at(i + 1).is_keyword("function")) {
      do names.push_back(at(++i).text);
      while (at(++i).is_symbol(","));
      return names;
    }
    const bool is_local = at(i).is_keyword("local");
    const bool is_function = at(i + (is_local ? 1 : 0)).is_keyword("function");
    const std::size_t first = i + (is_local ? 1 : 0) + (is_function ? 1 : 0);
    if (at(first).kind != Kind::name) return names;
    if (at(first + 1).is_symbol(".") || at(first + 1).is_symbol(":")) {
      if (is_function || at(first + 3).is_symbol("=")) names.push_back("module." + at(first + 2).text);
    } else if (is_function || at(first + 1).is_symbol("=")) {
      names.push_back(at(first).text);
    }
    return names;
  }

  std::string file_;
  std::vector<LuaToken> tokens_;
  std::map<std::string, std::string> modules_;     ///< file of each `local name = require "..."`
  std::map<std::string, Definition> definitions_;  ///< where there are several of a name, all of them
};

class SightSearch {
 public:
  SightSearch(const MachineDefinition& machine, const ScriptTexts& texts) : machine_(machine), texts_(texts) {}

  std::map<int, std::set<Sight>> run() {
    find_states();
    std::map<int, Passage> passages;
    for (const auto& [file, states] : states_) {
      const ScriptSource& source = source_of(file);
      for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i] >= 0) passages[states[i]].add(source.look_at(i));
      }
    }
    std::map<int, std::set<Sight>> all;
    for (const auto& [state, passage] : passages) {
      std::set<Sight> sights = follow(passage);
      if (!sights.empty()) all[state] = std::move(sights);
    }
    return all;
  }

 private:
  const ScriptSource& source_of(const std::string& file) {
    const auto known = sources_.find(file);
    if (known != sources_.end()) return known->second;
    const ScriptText* const text = texts_.find(file);
    return sources_.emplace(file, ScriptSource(file, text == nullptr ? std::string_view() : text->text)).first->second;
  }

  void find_states() {
    for (std::size_t state = 0; state < machine_.states.size(); ++state) {  // inner ones come after
      const StateDefinition& definition = machine_.states[state];
      const std::vector<LuaToken>& tokens = source_of(definition.file).tokens();
      std::vector<int>& states = states_[definition.file];
      states.resize(tokens.size(), -1);
      const auto name = std::lower_bound(
          tokens.begin(), tokens.end(), definition.position,
          [](const LuaToken& token, TextPosition position) { return is_before(token.position, position); });
      const auto brace = name == tokens.end() ? name : name + 1;
      if (definition.position.column == 0 || brace == tokens.end() || !brace->is_symbol("{")) continue;
      for (auto token = brace + 1; token != tokens.end() && token->depth > brace->depth; ++token)
        states[static_cast<std::size_t>(token - tokens.begin())] = static_cast<int>(state);
    }
  }

  /// A local name for a state: what is in it is that state's, not that of the table which names it.
  bool holds_a_state(const std::string& file, const ScriptSource::Definition& definition) const {
    const auto found = states_.find(file);
    if (found == states_.end()) return false;
    const auto first = found->second.begin();
    return std::any_of(first + static_cast<std::ptrdiff_t>(definition.begin),
                       first + static_cast<std::ptrdiff_t>(definition.end), [](int state) { return state >= 0; });
  }

  /// What a passage looks at, itself and through what it names.
  std::set<Sight> follow(const Passage& start) {
    std::set<Sight> sights = start.sights;
    std::set<Reference> seen;
    std::vector<Reference> next(start.references.begin(), start.references.end());
    while (!next.empty()) {
      const Reference reference = std::move(next.back());
      next.pop_back();
      if (!seen.insert(reference).second) continue;
      const ScriptSource::Definition* const named = source_of(reference.file).find(reference.name);
      if (named == nullptr || holds_a_state(reference.file, *named)) continue;
      const Passage& passage = named->passage;
      sights.insert(passage.sights.begin(), passage.sights.end());
      next.insert(next.end(), passage.references.begin(), passage.references.end());
    }
    return sights;
  }

  const MachineDefinition& machine_;
  const ScriptTexts& texts_;
  std::map<std::string, ScriptSource> sources_;
  /// By file: for each token the innermost state in whose braces it stands; -1: none.
  std::map<std::string, std::vector<int>> states_;
};

}  // namespace

std::map<int, std::set<Sight>> sights_of(const MachineDefinition& machine, const ScriptTexts& texts) {
  return SightSearch(machine, texts).run();
}

}  // namespace reorient
