// SPDX-License-Identifier: MIT
// Operators: the types of their operands, and comparisons that can never be true.
#include <string_view>

#include "workbench/script_tools/check/script_reading.h"

namespace reorient {
namespace {

using syntax::Expression;

/// The value's name in messages.
std::string subject(const Meaning& value) {
  if (!value.name.empty()) return value.name;
  if (value.literal == nullptr) return "this";
  return value.literal->kind == LuaToken::Kind::text ? "'" + value.literal->text + "'" : value.literal->text;
}

bool is_logic(std::string_view operation) { return operation == "and" || operation == "or"; }
bool is_logic(const Expression& expression) {
  return expression.kind == Expression::Kind::operation && is_logic(expression.operators.front()->text);
}

bool is_comparison(std::string_view operation) {
  return operation == "==" || operation == "~=" || operation == "<" || operation == ">" || operation == "<=" ||
         operation == ">=";
}

}  // namespace

void ScriptReading::require_type(const Meaning& value, ValueTypes expected, const LuaToken& place,
                                 const std::string& who) {
  need(value, expected);
  const ValueTypes types = unless_nil(value.types);
  if ((types & expected) != 0 || !is_without_metatable(value) || may_hold_a_number(value, expected)) return;
  const bool is_uncalled = types == kFunction && !value.name.empty();
  note(place, subject(value) + " is " + with_article(types) + ", and " + who + " takes " + with_article(expected) +
                  (is_uncalled ? ": call it, " + value.name + "()" : ""));
}

/// Lua converts a text to a number if it needs one. A literal or a named value as a number is still reported.
bool ScriptReading::may_hold_a_number(const Meaning& value, ValueTypes expected) {
  const bool is_any_text = value.literal == nullptr && value.names == nullptr;
  return (expected & kNumber) != 0 && (value.types & kString) != 0 && is_any_text;
}

Meaning ScriptReading::read_unary(const Expression& expression) {
  const Meaning value = read(expression.operands.front());
  const LuaToken& place = *expression.operands.front().token;
  if (expression.token->text == "not") {
    check_truth(value, place);
    return {kBoolean};
  }
  if (expression.token->text == "#") {
    require_type(value, kTable | kString, place, "'#'");
  } else {
    require_type(value, kNumber, place, "'" + expression.token->text + "'");
  }
  return {is_without_metatable(value) ? kNumber : kAnything};
}

Meaning ScriptReading::read_operation(const Expression& expression) {
  const std::string& operation = expression.operators.front()->text;
  if (is_logic(operation)) return read_logic(expression);
  if (is_comparison(operation)) return read_comparison(expression);
  const bool joins = operation == "..";
  bool is_plain = true;
  for (std::size_t i = 0; i < expression.operands.size(); ++i) {
    const Meaning value = read(expression.operands[i]);
    is_plain = is_plain && is_without_metatable(value);
    const LuaToken& nearest = *expression.operators[i == 0 ? 0 : i - 1];
    require_type(value, joins ? kNumber | kString : kNumber, *expression.operands[i].token, "'" + nearest.text + "'");
  }
  if (!is_plain) return {};
  return {joins ? kString : kNumber};
}

/// The operands after `and` and `or` may not be evaluated.
Meaning ScriptReading::read_logic(const Expression& expression) {
  const bool is_and = expression.operators.front()->text == "and";
  Meaning value = read(expression.operands.front());
  mark_open(value);
  ValueTypes types = value.types;
  for (std::size_t i = 1; i < expression.operands.size(); ++i) {
    check_truth(value, *expression.operands[i - 1].token);
    const Uncertain uncertain(*this);
    value = read(expression.operands[i]);
    mark_open(value);
    types = (is_and ? types & kFalsy : types & ~kFalsy) | value.types;
  }
  if (!is_logic(expression.operands.back())) end_of_logic_ = value;
  return {types};
}

Meaning ScriptReading::read_comparison(const Expression& expression) {
  Meaning left = read(expression.operands.front());
  for (std::size_t i = 0; i < expression.operators.size(); ++i) {
    const LuaToken& operation = *expression.operators[i];
    const Expression& right_side = expression.operands[i + 1];
    const Meaning right = read(right_side);
    if (operation.text == "==" || operation.text == "~=") {
      compare(*right_side.token, left, right);
    } else {
      compare_order(*right_side.token, left, right);
    }
    left = Meaning{kBoolean};
  }
  return {kBoolean};
}

void ScriptReading::compare(const LuaToken& place, const Meaning& left, const Meaning& right) {
  check_compared_name(left, right);
  check_compared_name(right, left);
  const ValueTypes of_left = left.types & ~kNil;
  const ValueTypes of_right = right.types & ~kNil;
  if (of_left == 0 || of_right == 0 || (of_left & of_right) != 0) return;
  if ((of_left & ~kBoolean) == 0 && (of_right & ~kBoolean) == 0) return;  // true == false
  note(place, subject(left) + " is " + with_article(of_left) + ", which is never equal to " + with_article(of_right));
}

void ScriptReading::check_compared_name(const Meaning& value, const Meaning& text) {
  if (value.names == nullptr || text.literal == nullptr || text.literal->kind != LuaToken::Kind::text) return;
  check_name(value.name, *value.names, *text.literal);
}

void ScriptReading::compare_order(const LuaToken& place, const Meaning& left, const Meaning& right) {
  constexpr ValueTypes kOrdered = kNumber | kString;
  const ValueTypes of_left = unless_nil(left.types);
  const ValueTypes of_right = unless_nil(right.types);
  need(left, (of_right & ~kOrdered) == 0 ? of_right : kAnything);
  need(right, (of_left & ~kOrdered) == 0 ? of_left : kAnything);
  for (const Meaning* side : {&left, &right}) {
    const ValueTypes types = unless_nil(side->types);
    if ((types & kOrdered) != 0 || !is_without_metatable(*side)) continue;
    return require_type(*side, kOrdered, place, "a comparison");
  }
  const bool both_are_known = ((of_left | of_right) & ~kOrdered) == 0;
  if (both_are_known && (of_left & of_right) == 0)
    note(place,
         subject(left) + " is " + with_article(of_left) + " and cannot be compared with " + with_article(of_right));
}

void ScriptReading::read_condition(const Expression& expression) { check_condition(expression, read(expression)); }

/// Also checks the last operand of `a() and b`, because it may be the result.
void ScriptReading::check_condition(const Expression& expression, const Meaning& value) {
  check_truth(value, *expression.token);
  const Expression* last = &expression;
  while (is_logic(*last)) last = &last->operands.back();
  if (last != &expression) check_truth(end_of_logic_, *last->token);
}

void ScriptReading::check_truth(const Meaning& value, const LuaToken& place) {
  // A script may test whether a function exists that neither it nor a module defines.
  const bool is_of_scripts =
      value.own_function != nullptr || known_.modules.contains(value.name.substr(0, value.name.rfind('.')));
  if (value.types != kFunction || !is_of_scripts || value.name.empty()) return;
  note(place, value.name + " is a function, which is always true: call it, " + value.name + "()",
       Finding::Severity::warning);
}

}  // namespace reorient
