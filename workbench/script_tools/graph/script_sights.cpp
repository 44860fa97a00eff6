// SPDX-License-Identifier: MIT
#include "workbench/script_tools/graph/script_sights.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "workbench/script_tools/syntax/lua_syntax.h"

namespace reorient {
namespace {

using syntax::Expression;
using syntax::Statement;
using syntax::Suffix;

/// A definition among the outermost statements of a file. Its name is "name" or "module.name".
struct Reference {
  std::string file;
  std::string name;

  bool operator<(const Reference& other) const { return std::tie(file, name) < std::tie(other.file, other.name); }
};

/// The machines that a part of a script reads, and the definitions that it refers to.
struct Passage {
  std::set<Sight> sights;
  std::set<Reference> references;

  void add(const Passage& other) {
    sights.insert(other.sights.begin(), other.sights.end());
    references.insert(other.references.begin(), other.references.end());
  }
};

bool is_text(const Expression& expression) {
  return expression.kind == Expression::Kind::literal && expression.token->kind == LuaToken::Kind::text;
}

/// The name in .name or ["name"]; empty for any other suffix and for a missing one.
std::string field_name(const std::vector<Suffix>& suffixes, std::size_t index) {
  if (index >= suffixes.size()) return {};
  const Suffix& suffix = suffixes[index];
  if (suffix.kind == Suffix::Kind::field) return suffix.place->text;
  const bool is_named = suffix.kind == Suffix::Kind::index && is_text(suffix.arguments.front());
  return is_named ? suffix.arguments.front().token->text : "";
}

/// The text that an operand is compared with, on either side; empty: it is not compared with a text.
std::string compared_text(const Expression& operation, std::size_t operand) {
  for (const std::size_t other : {operand + 1, operand - 1}) {
    if (other >= operation.operands.size() || !is_text(operation.operands[other])) continue;
    const LuaToken& sign = *operation.operators[std::min(operand, other)];
    if (sign.is_symbol("==") || sign.is_symbol("~=")) return operation.operands[other].token->text;
  }
  return {};
}

/// The names that a statement defines: `local a, b = ...`, `local function a`, `function m.a`, `m.a = ...`, `a = ...`.
std::vector<std::string> defined_names(const Statement& statement) {
  std::vector<std::string> names;
  for (const LuaToken* const name : statement.names) names.push_back(name->text);
  for (const Expression& target : statement.targets) {
    if (target.kind == Expression::Kind::name) names.push_back(target.token->text);
    if (const std::string field = field_name(target.suffixes, 0); !field.empty()) names.push_back("module." + field);
  }
  return names;
}

/// The file of `local name = require "..."`.
std::optional<std::string> required_file(const Statement& statement) {
  if (statement.kind != Statement::Kind::local || statement.names.size() != 1 || statement.values.size() != 1)
    return {};
  const Expression& value = statement.values.front();
  if (value.suffixes.size() != 1 || !value.token->is(LuaToken::Kind::name, "require")) return {};
  const std::vector<Expression>& arguments = value.suffixes.front().arguments;
  return arguments.size() == 1 && is_text(arguments.front()) ? module_file(arguments.front().token->text)
                                                             : std::nullopt;
}

class SightSearch {
 public:
  SightSearch(const MachineDefinition& machine, const ScriptTexts& texts) : machine_(machine), texts_(texts) {}

  std::map<int, std::set<Sight>> run() {
    for (const StateDefinition& state : machine_.states) read_file(state.file);
    std::map<int, std::set<Sight>> all;
    for (const auto& [state, passage] : states_) {
      std::set<Sight> sights = follow(passage);
      if (!sights.empty()) all[state] = std::move(sights);
    }
    return all;
  }

 private:
  void read_file(const std::string& file) {
    const ScriptText* const text = texts_.find(file);
    if (text == nullptr || !files_.insert(file).second) return;
    file_ = file;
    const syntax::Script script = syntax::read_script(text->text);
    for (const Statement& statement : script.body) {
      if (const auto required = required_file(statement)) {
        modules_[{file, statement.names.front()->text}] = *required;
        continue;
      }
      Passage passage;
      here_ = &passage;
      holds_a_state_ = false;
      read(statement);
      // The code in a state that a local variable holds belongs to that state, not to the table that refers to it.
      if (holds_a_state_) continue;
      for (const std::string& name : defined_names(statement)) definitions_[{file, name}].add(passage);
    }
  }

  void read(const Statement& statement) {
    for (const Expression& target : statement.targets) read(target);
    for (const Expression& value : statement.values) read(value);
    for (const syntax::Block& block : statement.blocks) read(block);
    if (statement.function != nullptr) read(statement.function->body);
  }

  void read(const syntax::Block& block) {
    for (const Statement& statement : block) read(statement);
  }

  void read(const Expression& expression, const std::string& compared_with = {}) {
    const bool is_suffixed = expression.kind == Expression::Kind::suffixed;
    const Expression& head = is_suffixed ? expression.operands.front() : expression;
    if (head.kind == Expression::Kind::name) look_at(head.token->text, expression.suffixes, compared_with);
    for (std::size_t i = 0; i < expression.operands.size(); ++i) {
      if (!is_suffixed || head.kind != Expression::Kind::name)
        read(expression.operands[i], compared_text(expression, i));
    }
    for (std::size_t i = 0; i < expression.suffixes.size(); ++i) {
      Passage* const around = here_;
      if (const int state = i == 0 ? -1 : named_state(expression.suffixes[i - 1]); state >= 0) {
        here_ = &states_[state];
        holds_a_state_ = true;
      }
      for (const Expression& argument : expression.suffixes[i].arguments) read(argument);
      here_ = around;
    }
    for (const syntax::Field& field : expression.fields) {
      for (const Expression& key : field.computed_key) read(key);
      read(field.value);
    }
    if (expression.function != nullptr) read(expression.function->body);
  }

  /// Index of the state that `"name"` in `state "name" { ... }` declares; -1: no state.
  int named_state(const Suffix& suffix) const {
    if (suffix.kind != Suffix::Kind::call) return -1;
    int index = static_cast<int>(machine_.states.size()) - 1;
    for (; index >= 0; --index) {
      const StateDefinition& state = machine_.states[static_cast<std::size_t>(index)];
      if (state.file == file_ && state.position == suffix.place->position) break;
    }
    return index;
  }

  void look_at(const std::string& name, const std::vector<Suffix>& suffixes, const std::string& compared_with) {
    const std::string field = field_name(suffixes, 0);
    if (name == "published") {
      if (!field.empty()) here_->sights.insert({"", field, ""});
    } else if (name == "behaviors") {
      const std::string seen = field_name(suffixes, 1);
      if (!field.empty())
        here_->sights.insert({field, seen, seen == "state" && suffixes.size() == 2 ? compared_with : ""});
    } else if (const auto module = modules_.find({file_, name}); module != modules_.end()) {
      here_->references.insert({module->second, "module." + field});
    } else {
      here_->references.insert({file_, name});
      if (!field.empty()) here_->references.insert({file_, "module." + field});
    }
  }

  /// The machines that a passage reads, directly and through the definitions that it refers to.
  std::set<Sight> follow(const Passage& start) {
    std::set<Sight> sights = start.sights;
    std::set<Reference> seen;
    std::vector<Reference> next(start.references.begin(), start.references.end());
    while (!next.empty()) {
      const Reference reference = std::move(next.back());
      next.pop_back();
      if (!seen.insert(reference).second) continue;
      read_file(reference.file);
      const Passage& passage = definitions_[reference];
      sights.insert(passage.sights.begin(), passage.sights.end());
      next.insert(next.end(), passage.references.begin(), passage.references.end());
    }
    return sights;
  }

  const MachineDefinition& machine_;
  const ScriptTexts& texts_;
  std::set<std::string> files_;               ///< files that were read
  std::map<Reference, std::string> modules_;  ///< file of each `local name = require "..."`
  std::map<Reference, Passage> definitions_;  ///< definitions with the same name are combined
  std::map<int, Passage> states_;             ///< code in the table of each state, without its inner states
  std::string file_;                          ///< file that is being read
  Passage* here_ = nullptr;                   ///< passage to which the code belongs
  bool holds_a_state_ = false;                ///< the outermost statement that is being read contains a state
};

}  // namespace

std::map<int, std::set<Sight>> sights_of(const MachineDefinition& machine, const ScriptTexts& texts) {
  return SightSearch(machine, texts).run();
}

}  // namespace reorient
