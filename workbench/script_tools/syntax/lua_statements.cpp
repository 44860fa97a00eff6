// SPDX-License-Identifier: MIT
#include <utility>

#include "workbench/script_tools/syntax/lua_parser.h"

namespace reorient::syntax {

Block Parser::read() {
  Block all;
  while (here().kind != LuaToken::Kind::end && !too_deep_) {
    read_statements(all);
    if (here().kind != LuaToken::Kind::end) ++at_;  // an unmatched `end`: not valid Lua, continue
  }
  return all;
}

bool Parser::ends_block() const {
  return here().kind == LuaToken::Kind::end || sees("end") || sees("else") || sees("elseif") || sees("until");
}

void Parser::read_statements(Block& block) {
  const Depth depth(*this);
  while (!ends_block() && !too_deep_) {
    if (take(";")) continue;
    block.push_back(read_statement());
  }
}

Block Parser::read_block() {
  Block block;
  read_statements(block);
  return block;
}

Statement Parser::read_statement() {
  Statement statement;
  if (take("break")) {
    statement.kind = Statement::Kind::leave;
  } else if (take("goto")) {
    statement.kind = Statement::Kind::leave;
    take_any();
  } else if (take("::")) {
    take_any();
    take("::");
  } else if (take("do")) {
    statement.blocks.push_back(read_block());
    take("end");
  } else if (take("while")) {
    statement.kind = Statement::Kind::loop;
    statement.values.push_back(read_expression());
    take("do");
    statement.blocks.push_back(read_block());
    take("end");
  } else if (take("repeat")) {
    statement.kind = Statement::Kind::loop;
    statement.tests_at_end = true;
    statement.blocks.push_back(read_block());
    if (take("until")) statement.values.push_back(read_expression());
  } else if (take("if")) {
    read_branch(statement);
  } else if (take("for")) {
    read_for(statement);
  } else if (take("function")) {
    read_function_statement(statement);
  } else if (take("local")) {
    read_local(statement);
  } else if (take("return")) {
    statement.kind = Statement::Kind::give;
    if (!ends_block() && !sees(";")) statement.values = read_expressions();
  } else {
    read_assignment_or_call(statement);
  }
  return statement;
}

void Parser::read_branch(Statement& statement) {
  statement.kind = Statement::Kind::branch;
  do {
    statement.values.push_back(read_expression());
    take("then");
    statement.blocks.push_back(read_block());
  } while (take("elseif") && !too_deep_);
  if (take("else")) statement.blocks.push_back(read_block());
  take("end");
}

void Parser::read_for(Statement& statement) {
  read_names(statement);
  statement.kind = take("=") ? Statement::Kind::count : Statement::Kind::walk;
  if (statement.kind == Statement::Kind::walk) take("in");
  statement.values = read_expressions();
  take("do");
  statement.blocks.push_back(read_block());
  take("end");
}

void Parser::read_names(Statement& statement) {
  do {
    if (const LuaToken* const name = take_name()) statement.names.push_back(name);
    if (take("<")) {  // <const>, <close>
      take_any();
      take(">");
    }
  } while (take(","));
}

void Parser::read_function_statement(Statement& statement) {
  statement.kind = Statement::Kind::function;
  Expression name;
  name.token = &here();
  if (take_name() != nullptr) name.kind = Expression::Kind::name;
  bool has_self = false;
  if (sees(".") || sees(":")) name = with_suffixes(std::move(name));
  while (sees(".") || sees(":")) {
    has_self = sees(":");
    ++at_;
    Suffix field;
    field.place = take_any();
    name.suffixes.push_back(std::move(field));
  }
  statement.targets.push_back(std::move(name));
  statement.function = read_function(has_self);
}

void Parser::read_local(Statement& statement) {
  if (take("function")) {
    statement.kind = Statement::Kind::local_function;
    if (const LuaToken* const name = take_name()) statement.names.push_back(name);
    statement.function = read_function(false);
    return;
  }
  statement.kind = Statement::Kind::local;
  read_names(statement);
  if (take("=")) statement.values = read_expressions();
}

void Parser::read_assignment_or_call(Statement& statement) {
  const std::size_t start = at_;
  do statement.targets.push_back(read_suffixed());
  while (take(",") && !too_deep_);
  if (take("=")) {
    statement.kind = Statement::Kind::assignment;
    statement.values = read_expressions();
    return;
  }
  statement.kind = Statement::Kind::call;
  statement.values = std::exchange(statement.targets, {});
  if (at_ == start) ++at_;  // not valid Lua: continue after it
}

Script read_script(std::string_view text) {
  Script script;
  script.tokens = lua_tokens(text);
  script.body = Parser(script.tokens).read();
  return script;
}

}  // namespace reorient::syntax
