// SPDX-License-Identifier: MIT
// A Lua script as a tree of statements and expressions, as far as a check needs it. Runs of operators of one rank and
// runs of suffixes (.name, [key], calls) are flat lists, so the tree is no deeper than the text nests.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/script/source/lua_tokens.h"

namespace reorient::syntax {

struct Statement;
struct Expression;
struct Field;
struct Suffix;
using Block = std::vector<Statement>;

struct Function {
  std::vector<const LuaToken*> parameters;
  bool has_self = false;  ///< declared with ':'
  bool is_variadic = false;
  Block body;
};

struct Expression {
  enum class Kind { none, literal, varargs, function, table, name, unary, operation, suffixed, parenthesis };

  Kind kind = Kind::none;
  const LuaToken* token = nullptr;         ///< with which it begins, never null; of unary the operator
  std::vector<Expression> operands;        ///< of operation two or more; of unary, suffixed and parenthesis one
  std::vector<const LuaToken*> operators;  ///< between the operands
  std::vector<Suffix> suffixes;
  std::vector<Field> fields;           ///< of a table
  std::unique_ptr<Function> function;  ///< of a function
};

struct Suffix {
  enum class Kind { field, index, call, method };

  Kind kind = Kind::field;
  const LuaToken* place = nullptr;    ///< the name of a field or method; of index and call the token after the name
  std::vector<Expression> arguments;  ///< of a call or method; of index the key
};

/// Of a table constructor.
struct Field {
  const LuaToken* key = nullptr;         ///< of `key = value` and `["key"] = value`
  std::vector<Expression> computed_key;  ///< of `[key] = value` otherwise: one
  Expression value;
};

struct Statement {
  enum class Kind { local, local_function, function, assignment, call, branch, loop, count, walk, block, give, leave };

  Kind kind = Kind::block;
  std::vector<const LuaToken*> names;  ///< that it declares: of local, count and walk (both kinds of `for`)
  std::vector<Expression> targets;     ///< of assignment; of function its name
  std::vector<Expression> values;      ///< of local, assignment, give (return), call; conditions of branch and loop
  std::vector<Block> blocks;           ///< of branch one for each condition, and one more for `else`
  bool tests_at_end = false;           ///< of loop: repeat ... until
  std::unique_ptr<Function> function;
};

struct Script {
  std::vector<LuaToken> tokens;  ///< to which the tree points
  Block body;
};

/// Of valid Lua the whole tree. Other text gives some tree, and what nests deeper than Lua allows is left out.
Script read_script(std::string_view text);

}  // namespace reorient::syntax
