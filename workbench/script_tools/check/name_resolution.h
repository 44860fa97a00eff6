// What the names of a script stand for, as far as that is plain from its text, and what is wrong with them.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/source/lua_tokens.h"
#include "workbench/script_tools/check/symbol_table.h"

namespace reorient {

/// What an expression stands for, as far as that is plain from the text.
struct Meaning {
  enum class Kind { anything, table, function, params, machines, machine, machine_state, published, name };

  Kind kind = Kind::anything;
  std::string name;                          ///< as it is called in messages; of a machine: its name
  const TableSymbol* table = nullptr;        ///< of a table
  const FunctionSymbol* function = nullptr;  ///< of a function
  std::set<std::string> keys;                ///< of params
};

struct Expression {
  Meaning meaning;
  const LuaToken* literal = nullptr;  ///< where it is one token: a text, a number, true, false or nil
  bool is_open_ended = false;         ///< a call or ..., which may stand for several values
  std::set<std::string> keys;         ///< of a table constructor
};

/// The scopes of a script while it is read from top to bottom. Each mistake is noted once, where it stands.
class NameResolution {
 public:
  explicit NameResolution(const SymbolTable& known) : known_(known) {}

  void open_scope() { scopes_.emplace_back(); }
  void close_scope() { scopes_.pop_back(); }
  void declare(const std::string& name, Meaning meaning = {}) { scopes_.back().emplace_back(name, std::move(meaning)); }

  /// A name that is read, and a field of something.
  Meaning of(const LuaToken& name);
  Meaning of_field(const Meaning& owner, const LuaToken& field);
  /// A name or field that is written. From then on a local name may stand for anything.
  void assign(const LuaToken& name);
  void assign_field(const Meaning& owner, const LuaToken& field);
  /// What a call gives: known of `param` and `require` only. `place`: of the arguments.
  Meaning call(const Meaning& function, const LuaToken& place, std::vector<Expression> arguments, bool in_condition);
  /// behaviors.NAME.state == "text", or robot.posture == "text", of which either side may be the text.
  void compare(const Expression& left, const Expression& right);

  /// In the order of the text.
  std::vector<DeclarationError> take_errors();

 private:
  using Scope = std::vector<std::pair<std::string, Meaning>>;

  Meaning* find_local(const std::string& name);
  void check_call(const Meaning& called, const LuaToken& place, const std::vector<Expression>& arguments,
                  bool in_condition);
  void check_compared_state(const Expression& state, const Expression& text);
  void check_compared_name(const Expression& value, const Expression& text);
  std::string hint(const std::string& wanted, const std::vector<std::string>& names);
  void note(const LuaToken& token, const std::string& message) { errors_.push_back({token.position, message}); }

  const SymbolTable& known_;
  std::vector<Scope> scopes_;
  int hints_ = 0;  ///< given so far
  std::vector<DeclarationError> errors_;
};

}  // namespace reorient
