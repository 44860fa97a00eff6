// SPDX-License-Identifier: MIT
// Calls: the function that is called, its arguments and its result.
#include <algorithm>
#include <string_view>

#include "engine/parameters/counted.h"
#include "workbench/script_tools/check/script_reading.h"

namespace reorient {
namespace {

using syntax::Expression;

std::string count_text(std::size_t count) { return count == 0 ? "no argument" : counted(count, "argument"); }

/// "head.look(yaw, pitch, speed?)"
std::string usage(const std::string& name, const FunctionSymbol& function) {
  std::string text;
  for (const ArgumentSymbol& argument : function.arguments)
    text.append(text.empty() ? "" : ", ").append(argument.name).append(argument.may_be_left_out ? "?" : "");
  if (function.more) text.append(text.empty() ? "..." : ", ...");
  return name + "(" + text + ")";
}

/// "argument 1 of head.look" for the index 0.
std::string argument_name(std::size_t index, const std::string& function) {
  return std::string("argument ").append(std::to_string(index + 1)).append(" of ").append(function);
}

/// Functions that iterate over a table without writing to it.
bool only_reads(const std::string& function) {
  return function == "pairs" || function == "ipairs" || function == "next";
}

bool is_text(const Meaning& value) { return value.literal != nullptr && value.literal->kind == LuaToken::Kind::text; }

std::string listed(const std::set<std::string>& names) {
  std::string all;
  for (const std::string& name : names) {
    if (!name.empty()) all.append(all.empty() ? "" : ", ").append(name);
  }
  return all;
}

}  // namespace

Meaning ScriptReading::read_call(const Meaning& called, const syntax::Suffix& call) {
  std::vector<Meaning> arguments = read_all(call.arguments);
  check_callable(called, *call.place);
  if (called.function != nullptr && arguments.size() == 1) {
    if (called.name == "param" || called.name == "args") return declared_parameters(called.name, arguments.front());
    if (called.name == "keep") {
      arguments.front().name.clear();
      return arguments.front();
    }
    if (called.name == "require" && is_text(arguments.front())) {
      const std::string& module = arguments.front().literal->text;
      const auto found = known_.modules.find(module);
      if (found != known_.modules.end()) return meaning_of(found->second, module);
    }
  }
  for (const Meaning& argument : arguments) {
    if (called.function != nullptr && only_reads(called.name) && argument.own_table != nullptr) {
      learned.tables[argument.own_table].is_walked = true;
    } else {
      mark_open(argument);
    }
  }
  return result_of(called, *call.place, arguments);
}

/// owner:name(...) passes the owner as the first argument.
Meaning ScriptReading::read_method_call(const Meaning& owner, const syntax::Suffix& call) {
  std::vector<Meaning> arguments = read_all(call.arguments);
  for (const Meaning& argument : arguments) mark_open(argument);
  Meaning method;
  const auto strings = known_.globals.fields.find("string");
  const bool is_string = unless_nil(owner.types) == kString && strings != known_.globals.fields.end();
  if (owner.table != nullptr) {
    method = field_of(owner, *call.place);
    if (method.function != nullptr) {
      note(*call.place, method.name + " is called with a dot, not with ':': " + usage(method.name, *method.function));
      method.function = nullptr;
    }
  } else {
    method = field_of(is_string ? meaning_of(strings->second, "string") : owner, *call.place);
  }
  check_callable(method, *call.place);
  mark_open(owner);
  arguments.insert(arguments.begin(), owner);
  return result_of(method, *call.place, arguments);
}

Meaning ScriptReading::result_of(const Meaning& called, const LuaToken& place, const std::vector<Meaning>& arguments) {
  Meaning result;
  result.most_values = kMany;
  if (!called.name.empty()) result.name = called.name + "()";
  const FunctionSymbol* const function = signature_of(called);
  if (function == nullptr) return result;
  if (function->acts) {
    frames_.back().learned.acts = true;
    if (in_condition_)
      note(place, called.name + " has an effect, which a condition must not have: call it in enter, update or exit");
  }
  check_arguments(called, *function, place, arguments);
  if (called.function != nullptr && called.name == "string.format") check_format(place, arguments);
  result.types = function->result;
  result.most_values = function->most_results;
  return result;
}

void ScriptReading::check_callable(const Meaning& called, const LuaToken& place) {
  need(called, kFunction | kTable);
  const ValueTypes types = unless_nil(called.types);
  if ((types & kFunction) != 0 || !is_without_metatable(called)) return;
  const std::string who = called.name.empty() ? "this" : called.name;
  std::string right = called.name.empty() ? "" : ": write it without ( )";
  if (called.table != nullptr) {
    std::string functions;
    for (const auto& [name, field] : called.table->fields) {
      if (field.function != nullptr)
        functions.append(functions.empty() ? "" : ", ")
            .append(usage(std::string(who).append(".").append(name), *field.function));
    }
    right = functions.empty() ? ": name one of its fields" : ": call " + functions;
  }
  note(place, who + " is " + with_article(types) + ", not a function" + right);
}

void ScriptReading::check_arguments(const Meaning& called, const FunctionSymbol& function, const LuaToken& place,
                                    const std::vector<Meaning>& arguments) {
  const std::string who = called.name.empty() ? "this function" : called.name;
  const std::vector<ArgumentSymbol>& expected = function.arguments;
  if (arguments.size() > expected.size() && !function.more) {
    note(place, who + ": expected " + count_text(expected.size()) + ", found " + std::to_string(arguments.size()) +
                    ": " + usage(who, function));
    return;
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const ArgumentSymbol& argument = i < expected.size() ? expected[i] : *function.more;
    check_argument(argument_name(i, who), argument, arguments[i], place);
    if (argument.is_state && i > 0) check_state(arguments[i - 1], arguments[i]);
  }
  const std::size_t given = arguments.empty() ? 0 : arguments.size() - 1 + arguments.back().most_values;
  std::size_t needed = expected.size();
  while (needed > 0 && expected[needed - 1].may_be_left_out) --needed;
  if (given < needed)
    note(place,
         who + ": expected " + count_text(needed) + ", found " + std::to_string(given) + ": " + usage(who, function));
}

void ScriptReading::check_argument(const std::string& what, const ArgumentSymbol& expected, const Meaning& given,
                                   const LuaToken& place) {
  ValueTypes fitting = expected.value.types | (expected.may_be_left_out ? kNil : 0);
  if ((fitting & kNil) == 0) need(given, fitting);
  if ((fitting & kString) != 0) fitting |= kNumber;  // Lua converts numbers to text where it expects text
  const ValueTypes types = unless_nil(given.types);
  if ((types & fitting) == 0 && is_without_metatable(given) && !may_hold_a_number(given, fitting)) {
    note(given.literal != nullptr ? *given.literal : place,
         what + ": expected " + with_article(expected.value.types) + ", found " + with_article(types));
  } else if (expected.value.names != nullptr && is_text(given)) {
    check_name(what, *expected.value.names, *given.literal);
  } else if (expected.value.table != nullptr && given.own_table != nullptr && given.name.empty()) {
    check_contents(expected.value, *given.own_table);
  }
}

/// The format needs one argument for each directive, and a number for each directive that prints a number.
void ScriptReading::check_format(const LuaToken& place, const std::vector<Meaning>& arguments) {
  if (arguments.empty() || !is_text(arguments.front())) return;
  const std::string& format = arguments.front().literal->text;
  std::size_t expected = 0;
  for (std::size_t at = format.find('%'); at != std::string::npos; at = format.find('%', at + 1)) {
    at = format.find_first_not_of("-+ #0123456789.", at + 1);
    if (at == std::string::npos) break;  // Lua rejects this format
    if (format[at] == '%') continue;
    ++expected;
    const bool is_text_like = std::string_view("sqp").find(format[at]) != std::string_view::npos;
    if (is_text_like || expected >= arguments.size()) continue;
    check_argument(argument_name(expected, "string.format"), {"", {kNumber}, false}, arguments[expected], place);
  }
  const std::size_t given = arguments.size() - 2 + arguments.back().most_values;
  if (given < expected || arguments.size() - 1 > expected)
    note(place, "string.format: expected " + count_text(expected) + " for this format, found " +
                    std::to_string(given < expected ? given : arguments.size() - 1));
}

/// Accepts a text with escapes, because it is not decoded here.
void ScriptReading::check_name(const std::string& what, const std::set<std::string>& names, const LuaToken& text) {
  if (names.contains(text.text) || text.text.find('\\') != std::string::npos) return;
  constexpr std::size_t kMostListed = 12;
  std::string right = hint(text.text, {names.begin(), names.end()});
  if (right.empty() && names.size() <= kMostListed && !names.empty()) right = " (expected " + listed(names) + ")";
  note(text, what + ": unknown value '" + text.text + "'" + right);
}

/// Checks the literals in a table constructor that is passed as an argument.
void ScriptReading::check_contents(const Symbol& expected, const Expression& table) {
  for (const syntax::Field& field : table.fields) {
    if (field.key == nullptr) continue;
    const auto found = expected.table->fields.find(field.key->text);
    if (found == expected.table->fields.end()) {
      note_missing(*expected.table, *field.key);
      continue;
    }
    const std::string name = (expected.table->name.empty() ? "" : expected.table->name + ".") + field.key->text;
    if (field.value.kind == Expression::Kind::literal) {
      const Meaning value = read_literal(*field.value.token);
      if ((found->second.types & value.types) == 0) {
        note(*field.value.token,
             name + ": expected " + with_article(found->second.types) + ", found " + with_article(value.types));
      } else if (found->second.names != nullptr) {
        check_name(name, *found->second.names, *field.value.token);
      }
    } else if (field.value.kind == Expression::Kind::table && found->second.table != nullptr) {
      check_contents(found->second, field.value);
    }
  }
}

/// Accepts states that the test itself adds with reload { from = ..., to = "state ..." }.
void ScriptReading::check_state(const Meaning& machine, const Meaning& path) {
  if (!is_text(machine) || !is_text(path)) return;
  const auto states = known_.states.find(machine.literal->text);
  if (states == known_.states.end() || states->second.empty() || states->second.contains(path.literal->text)) return;
  if (is_edited_in(path.literal->text)) return;
  note(*path.literal, machine.literal->text + ": unknown state '" + path.literal->text + "'" +
                          hint(path.literal->text, {states->second.begin(), states->second.end()}));
}

bool ScriptReading::is_edited_in(const std::string& path) const {
  const std::string name = path.substr(path.rfind('/') + 1);
  const std::vector<LuaToken>& tokens = script_.tokens;
  for (std::size_t i = 2; i < tokens.size(); ++i) {
    const bool is_edit = tokens[i - 2].is(LuaToken::Kind::name, "to") && tokens[i - 1].is_symbol("=");
    if (is_edit && tokens[i].text.find(name) != std::string::npos) return true;
  }
  return false;
}

/// The read-only table of the current values, each with the type of its default.
Meaning ScriptReading::declared_parameters(const std::string& word, const Meaning& declarations) {
  Meaning values{kTable, word};
  const auto facts = before_.tables.find(declarations.own_table);
  if (facts == before_.tables.end() || facts->second.is_open) return values;
  TableSymbol& table = parameter_tables_.emplace_back();
  table.name = word;
  table.missing = word == "param" ? "unknown param '" : "unknown argument '";
  for (const auto& [name, field] : facts->second.fields) {
    if (field.writes > 0) table.fields[name];
  }
  for (const syntax::Field& field : declarations.own_table->fields) {
    if (field.key == nullptr || field.value.kind != Expression::Kind::table) continue;
    const std::vector<syntax::Field>& parts = field.value.fields;
    const auto value = std::find_if(parts.begin(), parts.end(), [](const syntax::Field& part) {
      return part.key == nullptr && part.computed_key.empty();
    });
    if (value == parts.end() || value->value.kind != Expression::Kind::literal) continue;
    const ValueTypes types = read_literal(*value->value.token).types;
    table.fields[field.key->text].types = (types & kBoolean) != 0 ? kBoolean : types;
  }
  values.table = &table;
  return values;
}

}  // namespace reorient
