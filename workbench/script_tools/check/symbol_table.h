// SPDX-License-Identifier: MIT
// The names that a script may use, and their types, for checking scripts without running them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "workbench/script_tools/check/value_types.h"

namespace reorient {

struct FunctionSymbol;
struct TableSymbol;

/// A name, a field, an argument.
struct Symbol {
  ValueTypes types = kAnything;
  std::shared_ptr<const TableSymbol> table = nullptr;
  std::shared_ptr<const FunctionSymbol> function = nullptr;
  std::shared_ptr<const std::set<std::string>> names = nullptr;  ///< possible values of a string
  std::string replacement = {};                                  ///< of a former name: what to use instead
};

struct TableSymbol {
  std::string name;                      ///< name in messages: "robot", "lib.walk"
  std::string missing;                   ///< start of the message for a missing field: "there is no behavior '"
  std::map<std::string, Symbol> fields;  ///< all of them
  bool is_read_only = true;
};

struct ArgumentSymbol {
  std::string name;
  Symbol value;
  bool may_be_left_out = false;
  bool is_state = false;  ///< of the machine that the argument before names
};

/// Any number of values.
inline constexpr std::size_t kMany = 1'000'000;

/// A function that scripts may call.
struct FunctionSymbol {
  std::vector<ArgumentSymbol> arguments;
  std::optional<ArgumentSymbol> more;  ///< of "...", each
  ValueTypes result = kAnything;       ///< the first one
  std::size_t most_results = kMany;
  bool acts = false;  ///< so that conditions must not call it
};

/// The declarations of the scripts of a folder.
struct DeclaredNames {
  /// Paths of the states of each machine.
  std::map<std::string, std::set<std::string>> behaviors, scenarios;
  std::set<std::string> published;  ///< by some state
  std::set<std::string> parameters;
  std::set<std::string> behavior_scripts, scenario_scripts;  ///< by which they can be loaded
};

struct SymbolTable {
  TableSymbol globals;                                  ///< tables, functions, the words of the language
  std::map<std::string, Symbol> modules;                ///< by what `require` takes
  std::map<std::string, std::set<std::string>> states;  ///< of each machine that there is
  bool modules_use_metatables = false;                  ///< so that a table of theirs can stand for a number
};

/// The bindings' and the library's part of it; scenarios may name more than behaviors, tests their own words.
/// `declared`: nothing where it is not known what else there is.
enum class ScriptRole { behavior, scenario, library, test };
SymbolTable symbol_table(ScriptRole role, const std::optional<DeclaredNames>& declared);

}  // namespace reorient
