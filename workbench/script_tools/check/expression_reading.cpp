// SPDX-License-Identifier: MIT
// Types of expressions: literals, tables, names and their fields.
#include <algorithm>

#include "workbench/script_tools/check/script_reading.h"

namespace reorient {
namespace {

using syntax::Expression;

bool is_condition_key(const std::string& key) { return key == "when" || key == "lasting" || key == "after"; }

}  // namespace

Meaning ScriptReading::read(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::none:
      return {};
    case Expression::Kind::literal:
      return read_literal(*expression.token);
    case Expression::Kind::varargs: {
      Meaning several;
      several.most_values = kMany;
      return several;
    }
    case Expression::Kind::function:
      return read_function(*expression.function, false);
    case Expression::Kind::table:
      return read_table(expression);
    case Expression::Kind::name:
      return read_name(*expression.token);
    case Expression::Kind::unary:
      return read_unary(expression);
    case Expression::Kind::operation:
      return read_operation(expression);
    case Expression::Kind::suffixed:
      return read_suffixed(expression, expression.suffixes.size());
    case Expression::Kind::parenthesis: {
      Meaning one = read(expression.operands.front());
      one.most_values = 1;
      return one;
    }
  }
  return {};
}

std::vector<Meaning> ScriptReading::read_all(const std::vector<Expression>& expressions) {
  std::vector<Meaning> values;
  values.reserve(expressions.size());
  for (const Expression& expression : expressions) values.push_back(read(expression));
  return values;
}

Meaning ScriptReading::read_literal(const LuaToken& token) const {
  Meaning meaning;
  meaning.literal = &token;
  meaning.types = token.kind == LuaToken::Kind::text     ? kString
                  : token.kind == LuaToken::Kind::number ? kNumber
                  : token.text == "nil"                  ? kNil
                  : token.text == "true"                 ? kTrue
                                                         : kFalse;
  return meaning;
}

Meaning ScriptReading::read_table(const Expression& expression) {
  Meaning table{kTable};
  table.own_table = &expression;
  for (const syntax::Field& field : expression.fields) {
    const bool is_condition = field.key != nullptr && is_condition_key(field.key->text);
    const Meaning value = is_condition && field.value.kind == Expression::Kind::function
                              ? read_function(*field.value.function, true)
                              : read(field.value);
    mark_open(value);
    if (is_condition) {
      const FunctionSymbol* const function = signature_of(value);
      if (function != nullptr && function->acts && field.value.kind != Expression::Kind::function)
        note(*field.value.token,
             value.name + " has an effect, which a condition must not have: call it in enter, update or exit");
    }
    if (field.key != nullptr) {
      write_field(table, *field.key, value);
      learned.tables[&expression].fields[field.key->text].is_declared = true;
    }
    for (const Expression& key : field.computed_key) {
      if ((read(key).types & kString) != 0) learned.tables[&expression].is_open = true;
    }
  }
  learned.tables[&expression];  // an empty table gets an entry, too
  return table;
}

Meaning ScriptReading::read_name(const LuaToken& name) {
  if (const Local* const local = find_local(name.text)) return local->meaning;
  const auto found = known_.globals.fields.find(name.text);
  if (found != known_.globals.fields.end()) {
    note_former(found->second, name, name.text);
    return meaning_of(found->second, name.text);
  }
  note(name, known_.globals.missing + name.text + "'" + (has_hints_left() ? hint(name.text, all_names()) : ""));
  return {};
}

std::vector<std::string> ScriptReading::all_names() const {
  std::vector<std::string> names;
  for (const auto& global : known_.globals.fields) names.push_back(global.first);
  for (const std::vector<Local>& scope : scopes_) {
    for (const Local& local : scope) names.push_back(local.declaration->text);
  }
  return names;
}

Meaning ScriptReading::meaning_of(const Symbol& symbol, std::string name) const {
  Meaning meaning{symbol.types, std::move(name)};
  meaning.table = symbol.table.get();
  meaning.function = symbol.function.get();
  meaning.names = symbol.names.get();
  return meaning;
}

/// Reads the expression with its first `count` suffixes.
Meaning ScriptReading::read_suffixed(const Expression& expression, std::size_t count) {
  Meaning value = read(expression.operands.front());
  for (std::size_t i = 0; i < count; ++i) {
    const syntax::Suffix& suffix = expression.suffixes[i];
    switch (suffix.kind) {
      case syntax::Suffix::Kind::field:
        value = field_of(value, *suffix.place);
        break;
      case syntax::Suffix::Kind::index:
        value = item_of(value, suffix.arguments.front());
        break;
      case syntax::Suffix::Kind::call:
        value = read_call(value, suffix);
        break;
      case syntax::Suffix::Kind::method:
        value = read_method_call(value, suffix);
        break;
    }
  }
  return value;
}

void ScriptReading::note_former(const Symbol& symbol, const LuaToken& token, const std::string& name) {
  if (!symbol.replacement.empty())
    note(token, name + " is a former name: use " + symbol.replacement, Finding::Severity::warning);
}

Meaning ScriptReading::field_of(const Meaning& owner, const LuaToken& field) {
  need(owner, kTable | kString);
  if (owner.own_table != nullptr) return own_field_of(owner, field);
  if (owner.table != nullptr) {
    const auto found = owner.table->fields.find(field.text);
    if (found != owner.table->fields.end()) {
      const std::string name = owner.name + "." + field.text;
      note_former(found->second, field, name);
      return meaning_of(found->second, name);
    }
    note_missing(*owner.table, field);
    return {};
  }
  const ValueTypes types = unless_nil(owner.types);
  if ((types & (kTable | kString)) == 0) {
    const std::string who = owner.name.empty() ? "this" : owner.name;
    note(field, who + " is " + with_article(types) + " and has no field '" + field.text + "'" +
                    (types == kFunction ? ": call it, " + who + "()" : ""));
  }
  Meaning part;
  if (!owner.name.empty()) part.name = owner.name + "." + field.text;
  return part;
}

void ScriptReading::note_missing(const TableSymbol& table, const LuaToken& field) {
  std::vector<std::string> names;
  names.reserve(table.fields.size());
  for (const auto& known : table.fields) names.push_back(known.first);
  note(field, table.missing + field.text + (table.missing.ends_with('\'') ? "'" : "") + hint(field.text, names));
}

Meaning ScriptReading::own_field_of(const Meaning& owner, const LuaToken& field) {
  Meaning part{kAnything, owner.name.empty() ? field.text : owner.name + "." + field.text};
  FieldFacts& now = learned.tables[owner.own_table].fields[field.text];
  now.is_read = true;
  const auto table = before_.tables.find(owner.own_table);
  if (table == before_.tables.end() || table->second.is_open) return part;
  const auto found = table->second.fields.find(field.text);
  if (found == table->second.fields.end() || found->second.writes == 0) {
    std::vector<std::string> names;
    for (const auto& [name, known] : table->second.fields) {
      if (known.writes > 0) names.push_back(name);
    }
    note(field, part.name + " is read but never written, so it is nil" + hint(field.text, names),
         Finding::Severity::warning);
    return part;
  }
  part.types = found->second.types;
  if (found->second.writes == 1) part.own_function = found->second.function;
  return part;
}

Meaning ScriptReading::item_of(const Meaning& owner, const Expression& key_expression) {
  const Meaning key = read(key_expression);
  mark_open(key);
  const bool is_name = key.literal != nullptr && key.literal->kind == LuaToken::Kind::text;
  if (is_name && (owner.table != nullptr || owner.own_table != nullptr)) return field_of(owner, *key.literal);
  need(owner, kTable | kString);
  if (owner.own_table != nullptr) learned.tables[owner.own_table].is_walked = true;
  const ValueTypes types = unless_nil(owner.types);
  if ((types & (kTable | kString)) == 0)
    note(*key_expression.token,
         (owner.name.empty() ? "this" : owner.name) + " is " + with_article(types) + " and cannot be indexed");
  return {};
}

/// A table with a metatable may be used as a number, a text or a function.
bool ScriptReading::is_without_metatable(const Meaning& value) const {
  if (!uses_metatables_ || (value.types & kTable) == 0 || value.table != nullptr) return true;
  const auto own = before_.tables.find(value.own_table);
  return own != before_.tables.end() && !own->second.is_open;
}

const FunctionSymbol* ScriptReading::signature_of(const Meaning& value) const {
  if (value.function != nullptr) return value.function;
  const auto own = before_.functions.find(value.own_function);
  return own == before_.functions.end() ? nullptr : &own->second;
}

}  // namespace reorient
