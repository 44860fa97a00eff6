// SPDX-License-Identifier: MIT
// Statements and their declarations.
#include "workbench/script_tools/check/script_reading.h"

#include <algorithm>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

using syntax::Expression;
using syntax::Statement;

/// Whether the statements after it may not be reached. A `return` inside a nested function does not count.
bool may_leave(const Statement& statement) {
  if (statement.kind == Statement::Kind::give || statement.kind == Statement::Kind::leave) return true;
  return std::any_of(statement.blocks.begin(), statement.blocks.end(),
                     [](const syntax::Block& block) { return std::any_of(block.begin(), block.end(), may_leave); });
}

/// Meaning of the value at `index` of a list. The last expression may give several values.
Meaning value_at(const std::vector<Meaning>& values, std::size_t index) {
  if (index < values.size()) return values[index];
  if (!values.empty() && index < values.size() - 1 + values.back().most_values) return {};
  return {kNil};
}

}  // namespace

void ScriptReading::read() {
  const std::vector<LuaToken>& tokens = script_.tokens;
  uses_metatables_ = known_.modules_use_metatables || std::any_of(tokens.begin(), tokens.end(), [](const auto& token) {
                       return token.is(LuaToken::Kind::name, "setmetatable");
                     });
  frames_.emplace_back();
  read_scope(script_.body);
  for (const auto& table : learned.tables) report_unread_fields(table.second);
  std::stable_sort(findings.begin(), findings.end(),
                   [](const auto& left, const auto& right) { return is_before(left.position, right.position); });
}

void ScriptReading::read_block(const syntax::Block& block) {
  for (const Statement& statement : block) {
    read_statement(statement);
    if (may_leave(statement)) frames_.back().is_certain = false;
  }
}

void ScriptReading::read_scope(const syntax::Block& block) {
  scopes_.emplace_back();
  read_block(block);
  scopes_.pop_back();
}

void ScriptReading::read_statement(const Statement& statement) {
  switch (statement.kind) {
    case Statement::Kind::local:
      return read_local(statement);
    case Statement::Kind::local_function:
    case Statement::Kind::function:
      return read_function_statement(statement);
    case Statement::Kind::assignment:
      return read_assignment(statement);
    case Statement::Kind::call:
      for (const Expression& value : statement.values) read(value);
      return;
    case Statement::Kind::branch:
      return read_branch(statement);
    case Statement::Kind::loop:
      return read_loop(statement);
    case Statement::Kind::count:
    case Statement::Kind::walk:
      return read_for(statement);
    case Statement::Kind::block:
      for (const syntax::Block& block : statement.blocks) read_scope(block);
      return;
    case Statement::Kind::give:
      return read_return(statement);
    case Statement::Kind::leave:
      return;
  }
}

void ScriptReading::read_local(const Statement& statement) {
  const std::vector<Meaning> values = read_all(statement.values);
  for (std::size_t i = 0; i < statement.names.size(); ++i) declare(statement.names[i], value_at(values, i));
}

void ScriptReading::read_function_statement(const Statement& statement) {
  Meaning function{kFunction};
  function.own_function = statement.function.get();
  if (statement.kind == Statement::Kind::local_function) {
    // The body may use the name, so declare it first.
    if (!statement.names.empty()) declare(statement.names.front(), function);
    read_function(*statement.function, false);
    return;
  }
  assign(statement.targets.front(), function);
  read_function(*statement.function, false);
}

Meaning ScriptReading::read_function(const syntax::Function& function, bool is_condition) {
  Frame& frame = frames_.emplace_back();
  frame.function = &function;
  frame.is_condition = is_condition;
  frame.learned.result = 0;
  frame.learned.most_results = 0;
  scopes_.emplace_back();
  if (function.has_self) {
    static const LuaToken self{LuaToken::Kind::name, "self", {}, 0};
    frame.learned.arguments.push_back({"self", {}, true});
    declare(&self);
  }
  for (const LuaToken* const name : function.parameters) {
    frame.learned.arguments.push_back({name->text, {}, true});
    Meaning parameter;
    parameter.parameter = name;
    declare(name, parameter);
  }
  if (function.is_variadic) frame.learned.more = ArgumentSymbol{"...", {}, true};
  const bool was_condition = std::exchange(in_condition_, in_condition_ || is_condition);
  read_block(function.body);
  in_condition_ = was_condition;
  scopes_.pop_back();
  if (frame.learned.result == 0) frame.learned.result = kNil;
  learned.functions[&function] = std::move(frame.learned);
  frames_.pop_back();
  Meaning meaning{kFunction};
  meaning.own_function = &function;
  return meaning;
}

void ScriptReading::read_assignment(const Statement& statement) {
  const std::vector<Meaning> values = read_all(statement.values);
  for (std::size_t i = 0; i < statement.targets.size(); ++i) assign(statement.targets[i], value_at(values, i));
}

/// Writes the last name or field of the target and reads everything before it.
void ScriptReading::assign(const Expression& target, const Meaning& value) {
  if (target.kind == Expression::Kind::name) return assign_name(*target.token, value);
  mark_open(value);
  if (target.kind != Expression::Kind::suffixed) return;
  const Meaning owner = read_suffixed(target, target.suffixes.size() - 1);
  const syntax::Suffix& last = target.suffixes.back();
  if (last.kind == syntax::Suffix::Kind::field) return write_field(owner, *last.place, value);
  if (last.kind != syntax::Suffix::Kind::index) return;
  const Meaning key = read(last.arguments.front());
  if (key.literal != nullptr && key.literal->kind == LuaToken::Kind::text)
    return write_field(owner, *key.literal, value);
  if (owner.own_table != nullptr && (key.types & kString) != 0) learned.tables[owner.own_table].is_open = true;
}

void ScriptReading::assign_name(const LuaToken& name, const Meaning& value) {
  mark_open(value);
  if (const Local* const local = find_local(name.text)) {
    learned.assigned[local->declaration] |= value.types;
  } else if (known_.globals.fields.contains(name.text)) {
    note(name, "'" + name.text + "' is read-only");
  } else {
    note(name, "unknown variable '" + name.text + "': write 'local " + name.text +
                   "', or keep { } for values that survive a reload");
  }
}

void ScriptReading::write_field(const Meaning& owner, const LuaToken& field, const Meaning& value) {
  if (owner.table != nullptr && owner.table->is_read_only) note(field, owner.name + "." + field.text + " is read-only");
  if (owner.own_table == nullptr) return;
  FieldFacts& facts = learned.tables[owner.own_table].fields[field.text];
  facts.types |= value.types;
  if (facts.place == nullptr) facts.place = &field;
  facts.function = value.own_function;
  ++facts.writes;
}

void ScriptReading::read_branch(const Statement& statement) {
  for (std::size_t i = 0; i < statement.blocks.size(); ++i) {
    if (i == 0) read_condition(statement.values.front());
    const Uncertain uncertain(*this);
    if (i > 0 && i < statement.values.size()) read_condition(statement.values[i]);
    read_scope(statement.blocks[i]);
  }
}

/// The condition after `until` can use the locals of the block.
void ScriptReading::read_loop(const Statement& statement) {
  scopes_.emplace_back();
  if (statement.tests_at_end) {
    read_block(statement.blocks.front());
    if (!statement.values.empty()) read_condition(statement.values.front());
  } else {
    read_condition(statement.values.front());
    const Uncertain uncertain(*this);
    read_block(statement.blocks.front());
  }
  scopes_.pop_back();
}

void ScriptReading::read_for(const Statement& statement) {
  const bool counts = statement.kind == Statement::Kind::count;
  for (const Expression& value : statement.values) {
    const Meaning meaning = read(value);
    if (counts) require_type(meaning, kNumber, *value.token, "'for'");
  }
  scopes_.emplace_back();
  for (const LuaToken* const name : statement.names) declare(name, {counts ? kNumber : kAnything});
  const Uncertain uncertain(*this);
  read_block(statement.blocks.front());
  scopes_.pop_back();
}

void ScriptReading::read_return(const Statement& statement) {
  Frame& frame = frames_.back();
  std::size_t most_given = 0;
  for (std::size_t i = 0; i < statement.values.size(); ++i) {
    const Meaning value = read(statement.values[i]);
    most_given = i + value.most_values;
    if (i == 0) frame.learned.result |= value.types;
    if (i == 0 && frame.is_condition) check_condition(statement.values[i], value);
    if (frame.function == nullptr && i == 0 && value.own_table != nullptr) {
      learned.returned = value.own_table;
      learned.tables[value.own_table].is_walked = true;
    } else {
      mark_open(value);
    }
  }
  if (statement.values.empty()) frame.learned.result |= kNil;
  frame.learned.most_results = std::max(frame.learned.most_results, most_given);
}

/// A local that is assigned several times may have the types of all its values.
void ScriptReading::declare(const LuaToken* name, Meaning meaning) {
  meaning.literal = nullptr;
  meaning.most_values = 1;
  if (meaning.types == kNil) meaning.types = kAnything;  // code may write a value later
  if (const auto found = before_.assigned.find(name); found != before_.assigned.end()) {
    learned.assigned[name] |= meaning.types;
    mark_open(meaning);
    meaning = Meaning{found->second};
  }
  if (meaning.name.empty()) meaning.name = name->text;
  scopes_.back().push_back({name, std::move(meaning)});
}

ScriptReading::Local* ScriptReading::find_local(std::string_view name) {
  for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
    for (auto local = scope->rbegin(); local != scope->rend(); ++local) {
      if (local->declaration->text == name) return &*local;
    }
  }
  return nullptr;
}

/// Reports a field that is never read if its name is similar to one that is read: `memory.lokos = 1` after
/// `keep { looks = 0 }`, or vice versa. Two fields of the constructor are never taken for a misspelling of each other.
void ScriptReading::report_unread_fields(const TableFacts& table) {
  if (table.is_open || table.is_walked) return;
  std::vector<std::string> declared;
  std::vector<std::string> undeclared;
  for (const auto& [name, field] : table.fields) {
    if (field.is_read && field.writes > 0) (field.is_declared ? declared : undeclared).push_back(name);
  }
  for (const auto& [name, field] : table.fields) {
    const std::vector<std::string>& others = field.is_declared ? undeclared : declared;
    if (field.is_read || others.empty()) continue;
    if (const std::string right = hint(name, others); !right.empty())
      note(*field.place, std::string("'").append(name).append("' is written but never read").append(right),
           Finding::Severity::warning);
  }
}

/// If the value is a parameter of the innermost function: it is required, and must have one of these types.
void ScriptReading::need(const Meaning& value, ValueTypes expected) {
  Frame& frame = frames_.back();
  if (value.parameter == nullptr || frame.function == nullptr || !frame.is_certain) return;
  const std::vector<const LuaToken*>& names = frame.function->parameters;
  const auto found = std::find(names.begin(), names.end(), value.parameter);
  if (found == names.end()) return;  // a parameter of an outer function
  const std::size_t index = static_cast<std::size_t>(found - names.begin()) + (frame.function->has_self ? 1 : 0);
  ArgumentSymbol& argument = frame.learned.arguments[index];
  argument.may_be_left_out = false;
  const ValueTypes both = argument.value.types & expected & ~kNil;
  argument.value.types = both != 0 ? both : kAnything;
}

/// Code that is not followed may write to the table from now on.
void ScriptReading::mark_open(const Meaning& value) {
  if (value.own_table != nullptr) learned.tables[value.own_table].is_open = true;
}

std::string ScriptReading::hint(std::string_view unknown, const std::vector<std::string>& names) {
  if (!has_hints_left()) return {};
  ++hints_;
  return did_you_mean(unknown, names);
}

void ScriptReading::note(const LuaToken& place, std::string message, Finding::Severity severity) {
  findings.push_back({severity, {}, place.position, std::move(message)});
}

}  // namespace reorient
