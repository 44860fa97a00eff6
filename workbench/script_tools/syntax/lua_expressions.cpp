// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "workbench/script_tools/syntax/lua_parser.h"

namespace reorient::syntax {
namespace {

using TokenKind = LuaToken::Kind;

constexpr int kUnaryRank = 11;

struct Rank {
  std::string_view operation;
  int rank;
};
// clang-format off
constexpr std::array<Rank, 21> kRanks{{
    {"or", 1}, {"and", 2}, {"<", 3}, {">", 3}, {"<=", 3}, {">=", 3}, {"~=", 3}, {"==", 3}, {"|", 4}, {"~", 5}, {"&", 6},
    {"<<", 7}, {">>", 7}, {"..", 8}, {"+", 9}, {"-", 9}, {"*", 10}, {"/", 10}, {"//", 10}, {"%", 10}, {"^", 12}}};
// clang-format on

/// Rank of a binary operator; 0: it is not one.
int rank_of(const LuaToken& token) {
  if (token.kind != TokenKind::symbol && token.kind != TokenKind::keyword) return 0;
  for (const Rank& row : kRanks) {
    if (row.operation == token.text) return row.rank;
  }
  return 0;
}

}  // namespace

std::vector<Expression> Parser::read_expressions() {
  std::vector<Expression> all;
  do all.push_back(read_expression());
  while (take(",") && !too_deep_);
  return all;
}

Expression Parser::read_expression() { return read_operation(0); }

/// Reads operators that bind more tightly than `rank`.
Expression Parser::read_operation(int rank) {
  const Depth depth(*this);
  Expression left;
  left.token = &here();
  if (too_deep_) return left;
  left = read_operand();
  while (rank_of(here()) > rank && !too_deep_) {
    const int found = rank_of(here());
    Expression operation;
    operation.kind = Expression::Kind::operation;
    operation.token = left.token;
    operation.operands.push_back(std::move(left));
    while (rank_of(here()) == found && !too_deep_) {
      operation.operators.push_back(take_any());
      operation.operands.push_back(read_operation(found));
    }
    left = std::move(operation);
  }
  return left;
}

Expression Parser::read_operand() {
  if (!sees("-") && !sees("#") && !sees("~") && !sees("not")) return read_simple();
  Expression unary;
  unary.kind = Expression::Kind::unary;
  unary.token = take_any();
  unary.operands.push_back(read_operation(kUnaryRank));
  return unary;
}

Expression Parser::read_simple() {
  const LuaToken& token = here();
  const bool is_literal =
      token.kind == TokenKind::number || token.kind == TokenKind::text || sees("nil") || sees("true") || sees("false");
  Expression simple;
  simple.token = &token;
  if (is_literal) {
    simple.kind = Expression::Kind::literal;
    ++at_;
  } else if (take("...")) {
    simple.kind = Expression::Kind::varargs;
  } else if (sees("{")) {
    simple = read_table();
  } else if (take("function")) {
    simple.kind = Expression::Kind::function;
    simple.function = read_function(false);
  } else {
    simple = read_suffixed();
  }
  return simple;
}

Expression Parser::read_table() {
  const Depth depth(*this);
  Expression table;
  table.kind = Expression::Kind::table;
  table.token = take_any();
  while (!sees("}") && here().kind != TokenKind::end && !too_deep_) {
    table.fields.push_back(read_field());
    if (!take(",") && !take(";") && !sees("}")) break;
  }
  take("}");
  return table;
}

Field Parser::read_field() {
  Field field;
  if (take("[")) {
    Expression key = read_expression();
    if (key.kind == Expression::Kind::literal && key.token->kind == TokenKind::text) {
      field.key = key.token;
    } else {
      field.computed_key.push_back(std::move(key));
    }
    take("]");
    take("=");
  } else if (here().kind == TokenKind::name && after().is_symbol("=")) {
    field.key = take_any();
    take("=");
  }
  field.value = read_expression();
  return field;
}

std::unique_ptr<Function> Parser::read_function(bool has_self) {
  const Depth depth(*this);
  auto function = std::make_unique<Function>();
  function->has_self = has_self;
  take("(");
  while (!sees(")") && here().kind != TokenKind::end) {
    const LuaToken* const parameter = take_any();
    if (parameter->kind == TokenKind::name) function->parameters.push_back(parameter);
    if (parameter->is_symbol("...")) function->is_variadic = true;
    if (!take(",")) break;
  }
  take(")");
  function->body = read_block();
  take("end");
  return function;
}

Expression Parser::with_suffixes(Expression head) {
  Expression suffixed;
  suffixed.kind = Expression::Kind::suffixed;
  suffixed.token = head.token;
  suffixed.operands.push_back(std::move(head));
  return suffixed;
}

Expression Parser::read_suffixed() {
  Expression value;
  value.token = &here();
  if (take("(")) {
    value.kind = Expression::Kind::parenthesis;
    value.operands.push_back(read_expression());
    take(")");
  } else if (take_name() != nullptr) {
    value.kind = Expression::Kind::name;
  } else {
    if (here().kind != TokenKind::end && !ends_block()) ++at_;  // not valid Lua: continue after it
    return value;
  }
  while (!too_deep_) {
    Suffix suffix;
    if (!read_suffix(suffix)) break;
    if (value.kind != Expression::Kind::suffixed) value = with_suffixes(std::move(value));
    value.suffixes.push_back(std::move(suffix));
  }
  return value;
}

bool Parser::read_suffix(Suffix& suffix) {
  suffix.place = &here();
  if (take(".")) {
    suffix.place = take_any();
  } else if (take("[")) {
    suffix.kind = Suffix::Kind::index;
    suffix.arguments.push_back(read_expression());
    take("]");
  } else if (take(":")) {
    suffix.kind = Suffix::Kind::method;
    suffix.place = take_any();
    suffix.arguments = read_arguments();
  } else if (sees("(") || sees("{") || here().kind == TokenKind::text) {
    suffix.kind = Suffix::Kind::call;
    suffix.arguments = read_arguments();
  } else {
    return false;
  }
  return true;
}

std::vector<Expression> Parser::read_arguments() {
  std::vector<Expression> arguments;
  if (take("(")) {
    if (!sees(")")) arguments = read_expressions();
    take(")");
  } else if (sees("{") || here().kind == TokenKind::text) {
    arguments.push_back(read_simple());
  }
  return arguments;
}

}  // namespace reorient::syntax
