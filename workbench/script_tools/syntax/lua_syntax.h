// SPDX-License-Identifier: MIT
// A Lua script as a tree of statements and expressions, as far as a check needs it. Successive operators of one rank
// and successive suffixes (.name, [key], calls) are flat lists, so the tree is no deeper than the nesting of the text.
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
  const LuaToken* token = nullptr;         ///< first token, never null; unary: the operator
  std::vector<Expression> operands;        ///< operation: two or more; unary, suffixed and parenthesis: one
  std::vector<const LuaToken*> operators;  ///< between the operands
  std::vector<Suffix> suffixes;
  std::vector<Field> fields;           ///< of a table
  std::unique_ptr<Function> function;  ///< of a function
};

struct Suffix {
  enum class Kind { field, index, call, method };

  Kind kind = Kind::field;
  const LuaToken* place = nullptr;    ///< field and method: the name; index and call: the token after the name
  std::vector<Expression> arguments;  ///< call and method: the arguments; index: the key
};

/// An entry of a table constructor.
struct Field {
  const LuaToken* key = nullptr;         ///< the key of `key = value` and `["key"] = value`
  std::vector<Expression> computed_key;  ///< the key of any other `[key] = value`: one
  Expression value;
};

struct Statement {
  enum class Kind { local, local_function, function, assignment, call, branch, loop, count, walk, block, give, leave };

  Kind kind = Kind::block;
  std::vector<const LuaToken*> names;  ///< declared names: local, count and walk (the two forms of `for`)
  std::vector<Expression> targets;     ///< assignment: the targets; function: its name
  std::vector<Expression> values;      ///< values; branch and loop: the conditions; give is `return`
  std::vector<Block> blocks;           ///< branch: one for each condition, and one more for `else`
  bool tests_at_end = false;           ///< loop: repeat ... until
  std::unique_ptr<Function> function;
};

struct Script {
  std::vector<LuaToken> tokens;  ///< the tree points to them
  Block body;
};

/// The whole tree of valid Lua. Invalid text gives some tree; parts that nest deeper than Lua allows are omitted.
Script read_script(std::string_view text);

}  // namespace reorient::syntax
