// SPDX-License-Identifier: MIT
// The names that a script may use, and their types, for checking scripts without running them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robots/application.h"
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
  std::string replacement = {};                                  ///< the present name, if this is a former one
};

struct TableSymbol {
  std::string name;                      ///< name in messages: "robot", "lib.walk"
  std::string missing;                   ///< start of the message for an unknown field: "unknown behavior '"
  std::map<std::string, Symbol> fields;  ///< all of them
  bool is_read_only = true;
};

struct ArgumentSymbol {
  std::string name;
  Symbol value;
  bool may_be_left_out = false;
  bool is_state = false;  ///< a state of the machine in the previous argument
};

/// Any number of values.
inline constexpr std::size_t kMany = 1'000'000;

/// A function that scripts may call.
struct FunctionSymbol {
  std::vector<ArgumentSymbol> arguments;
  std::optional<ArgumentSymbol> more;  ///< each argument of "..."
  ValueTypes result = kAnything;       ///< first result
  std::size_t most_results = kMany;
  bool acts = false;  ///< it has an effect, so conditions must not call it
};

/// The declarations of the scripts of a folder.
struct DeclaredNames {
  /// Paths of the states of each machine. No paths: they are not known.
  std::map<std::string, std::set<std::string>> behaviors, scenarios;
  std::set<std::string> published;  ///< flags that some state publishes
  std::set<std::string> parameters;
  std::set<std::string> behavior_scripts, scenario_scripts;  ///< names under which they can be loaded
  std::vector<ApplicationInterface> interfaces;              ///< any of which a run may have
};

struct SymbolTable {
  TableSymbol globals;                                  ///< tables, functions, keywords of the language
  std::map<std::string, Symbol> modules;                ///< by the argument of `require`
  std::map<std::string, std::set<std::string>> states;  ///< of each machine
  bool modules_use_metatables = false;                  ///< so their tables may be used as numbers
};

/// The names of the bindings and of Lua's library. Scenarios know more names than behaviors; tests have their own.
enum class ScriptRole { behavior, scenario, library, test };
SymbolTable symbol_table(ScriptRole role, const DeclaredNames& declared);

}  // namespace reorient
