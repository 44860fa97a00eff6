// SPDX-License-Identifier: MIT
// Reads a script once from top to bottom: the types of its values, and errors.
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "workbench/script_tools/check/finding.h"
#include "workbench/script_tools/check/script_facts.h"
#include "workbench/script_tools/check/symbol_table.h"
#include "workbench/script_tools/syntax/lua_syntax.h"

namespace reorient {

/// The meaning of an expression, as far as the text determines it.
struct Meaning {
  Meaning(ValueTypes its_types = kAnything, std::string its_name = {}) : types(its_types), name(std::move(its_name)) {}

  ValueTypes types;
  std::string name;                                ///< name in messages; may be empty
  const TableSymbol* table = nullptr;              ///< if it is a table from outside the script
  const FunctionSymbol* function = nullptr;        ///< if it is a function with known arguments
  const std::set<std::string>* names = nullptr;    ///< possible values of a string
  const syntax::Expression* own_table = nullptr;   ///< if it is a table of the script: its constructor
  const syntax::Function* own_function = nullptr;  ///< if it is a function of the script
  const LuaToken* parameter = nullptr;             ///< if it is a parameter of a function: its declaration
  const LuaToken* literal = nullptr;               ///< if it is one token: a text, a number, true, false or nil
  std::size_t most_values = 1;                     ///< a call or ... may give several
};

/// Uses the facts `before` of an earlier reading and collects them again, so that a second reading knows a function
/// that is defined after its caller.
class ScriptReading {
 public:
  /// All must outlive the reading.
  ScriptReading(const syntax::Script& script, const SymbolTable& known, const ScriptFacts& before)
      : script_(script), known_(known), before_(before) {}

  void read();

  ScriptFacts learned;
  std::vector<Finding> findings;

 private:
  struct Local {
    const LuaToken* declaration = nullptr;
    Meaning meaning;
  };
  /// A function whose body is being read.
  struct Frame {
    const syntax::Function* function = nullptr;
    FunctionSymbol learned;
    bool is_condition = false;
    bool is_certain = true;  ///< the current code runs whenever the function is called
  };
  /// While it exists, the code that is read may not be executed.
  struct Uncertain {
    explicit Uncertain(ScriptReading& owner) : frame(owner.frames_.back()), was_certain(frame.is_certain) {
      frame.is_certain = false;
    }
    ~Uncertain() { frame.is_certain = was_certain; }
    Uncertain(const Uncertain&) = delete;
    Uncertain& operator=(const Uncertain&) = delete;
    Frame& frame;
    bool was_certain;
  };

  // Statements: script_reading.cpp.
  void read_block(const syntax::Block& block);
  void read_scope(const syntax::Block& block);
  void read_statement(const syntax::Statement& statement);
  void read_local(const syntax::Statement& statement);
  void read_function_statement(const syntax::Statement& statement);
  void read_assignment(const syntax::Statement& statement);
  void read_branch(const syntax::Statement& statement);
  void read_loop(const syntax::Statement& statement);
  void read_for(const syntax::Statement& statement);
  void read_return(const syntax::Statement& statement);
  void assign(const syntax::Expression& target, const Meaning& value);
  void assign_name(const LuaToken& name, const Meaning& value);
  void write_field(const Meaning& owner, const LuaToken& field, const Meaning& value);
  Meaning read_function(const syntax::Function& function, bool is_condition);
  void declare(const LuaToken* name, Meaning meaning = {});
  Local* find_local(std::string_view name);
  void report_unread_fields(const TableFacts& table);

  // Expressions: expression_reading.cpp.
  Meaning read(const syntax::Expression& expression);
  std::vector<Meaning> read_all(const std::vector<syntax::Expression>& expressions);
  Meaning read_literal(const LuaToken& token) const;
  Meaning read_table(const syntax::Expression& expression);
  Meaning read_name(const LuaToken& name);
  std::vector<std::string> all_names() const;
  Meaning read_suffixed(const syntax::Expression& expression, std::size_t count);
  Meaning field_of(const Meaning& owner, const LuaToken& field);
  void note_former(const Symbol& symbol, const LuaToken& token, const std::string& name);
  void note_missing(const TableSymbol& table, const LuaToken& field);
  Meaning own_field_of(const Meaning& owner, const LuaToken& field);
  Meaning item_of(const Meaning& owner, const syntax::Expression& key);
  Meaning meaning_of(const Symbol& symbol, std::string name) const;
  void mark_open(const Meaning& value);

  // Operators: operator_check.cpp.
  Meaning read_unary(const syntax::Expression& expression);
  Meaning read_operation(const syntax::Expression& expression);
  Meaning read_logic(const syntax::Expression& expression);
  Meaning read_comparison(const syntax::Expression& expression);
  void compare(const LuaToken& place, const Meaning& left, const Meaning& right);
  void compare_order(const LuaToken& place, const Meaning& left, const Meaning& right);
  void check_compared_name(const Meaning& value, const Meaning& text);
  void require_type(const Meaning& value, ValueTypes expected, const LuaToken& place, const std::string& who);
  void read_condition(const syntax::Expression& expression);
  void check_condition(const syntax::Expression& expression, const Meaning& value);
  void check_truth(const Meaning& value, const LuaToken& place);

  // Calls: call_check.cpp.
  Meaning read_call(const Meaning& called, const syntax::Suffix& call);
  Meaning read_method_call(const Meaning& owner, const syntax::Suffix& call);
  Meaning result_of(const Meaning& called, const LuaToken& place, const std::vector<Meaning>& arguments);
  void check_callable(const Meaning& called, const LuaToken& place);
  void check_arguments(const Meaning& called, const FunctionSymbol& function, const LuaToken& place,
                       const std::vector<Meaning>& arguments);
  void check_argument(const std::string& what, const ArgumentSymbol& expected, const Meaning& given,
                      const LuaToken& place);
  void check_name(const std::string& what, const std::set<std::string>& names, const LuaToken& text);
  void check_contents(const Symbol& expected, const syntax::Expression& table);
  void check_format(const LuaToken& place, const std::vector<Meaning>& arguments);
  void check_state(const Meaning& machine, const Meaning& path);
  bool is_edited_in(const std::string& path) const;
  Meaning declared_parameters(const std::string& word, const Meaning& declarations);

  void need(const Meaning& value, ValueTypes expected);
  static bool may_hold_a_number(const Meaning& value, ValueTypes expected);
  bool is_without_metatable(const Meaning& value) const;
  const FunctionSymbol* signature_of(const Meaning& value) const;
  /// Limits the search for similar names, which is slow.
  bool has_hints_left() const { return hints_ < 20; }
  std::string hint(std::string_view unknown, const std::vector<std::string>& names);
  void note(const LuaToken& place, std::string message, Finding::Severity severity = Finding::Severity::error);

  const syntax::Script& script_;
  const SymbolTable& known_;
  const ScriptFacts& before_;
  std::vector<std::vector<Local>> scopes_;
  std::deque<Frame> frames_;  ///< references into it stay valid; the first one is the script itself
  std::deque<TableSymbol> parameter_tables_;
  bool uses_metatables_ = true;
  bool in_condition_ = false;
  Meaning end_of_logic_;  ///< last operand of the `a and b` that was read last
  int hints_ = 0;         ///< number of hints so far
};

}  // namespace reorient
