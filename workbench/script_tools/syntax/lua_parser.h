// SPDX-License-Identifier: MIT
// Parses Lua by recursive descent into a tree, because Lua's own parser gives no tree.
#pragma once

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "workbench/script_tools/syntax/lua_syntax.h"

namespace reorient::syntax {

class Parser {
 public:
  explicit Parser(const std::vector<LuaToken>& tokens) : tokens_(tokens) {}

  Block read();

 private:
  /// Larger than the limit of Lua itself.
  static constexpr int kDeepest = 250;

  /// One level of nesting while it exists. Beyond kDeepest, reading ends.
  struct Depth {
    explicit Depth(Parser& owner) : parser(owner) { parser.too_deep_ |= ++parser.depth_ > kDeepest; }
    ~Depth() { --parser.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Parser& parser;
  };

  const LuaToken& here() const { return tokens_[std::min(at_, tokens_.size() - 1)]; }
  const LuaToken& after() const { return tokens_[std::min(at_ + 1, tokens_.size() - 1)]; }
  bool sees(std::string_view text) const {
    return (here().kind == LuaToken::Kind::symbol || here().kind == LuaToken::Kind::keyword) && here().text == text;
  }
  bool take(std::string_view text) {
    if (!sees(text)) return false;
    ++at_;
    return true;
  }
  const LuaToken* take_any() {
    const LuaToken* const token = &here();
    if (token->kind != LuaToken::Kind::end) ++at_;
    return token;
  }
  const LuaToken* take_name() { return here().kind == LuaToken::Kind::name ? take_any() : nullptr; }

  // lua_statements.cpp
  bool ends_block() const;
  void read_statements(Block& block);
  Block read_block();
  Statement read_statement();
  void read_branch(Statement& statement);
  void read_for(Statement& statement);
  void read_names(Statement& statement);
  void read_function_statement(Statement& statement);
  void read_local(Statement& statement);
  void read_assignment_or_call(Statement& statement);

  // lua_expressions.cpp
  std::vector<Expression> read_expressions();
  Expression read_expression();
  Expression read_operation(int rank);
  Expression read_operand();
  Expression read_simple();
  Expression read_table();
  Field read_field();
  std::unique_ptr<Function> read_function(bool has_self);
  static Expression with_suffixes(Expression head);
  Expression read_suffixed();
  bool read_suffix(Suffix& suffix);
  std::vector<Expression> read_arguments();

  const std::vector<LuaToken>& tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool too_deep_ = false;
};

}  // namespace reorient::syntax
