// What a script may name, for whoever checks scripts without running them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace reorient {

/// A function that scripts may call.
struct FunctionSymbol {
  std::vector<std::string> argument_types;  ///< "number", "boolean", "string"; with a "?" where it may be left out
  bool acts = false;                        ///< so that conditions must not call it
};

/// A global table, or what a module returns.
struct TableSymbol {
  std::set<std::string> fields;
  std::map<std::string, FunctionSymbol> functions;  ///< of those fields whose arguments are known
  bool is_read_only = true;
};

struct SymbolTable {
  std::set<std::string> globals;  ///< all of them: tables, functions, the words of the language
  std::map<std::string, FunctionSymbol> functions;
  std::map<std::string, TableSymbol> tables;
  std::map<std::string, TableSymbol> modules;           ///< by what `require` takes
  std::map<std::string, std::set<std::string>> states;  ///< paths of each machine that there is
  std::map<std::string, std::set<std::string>> names;   ///< all that a field of the world that is a name can be
  std::optional<std::set<std::string>> published;       ///< by some state; nothing: it is not known by which
};

/// The bindings' and the library's part of it; scenarios may name more than behaviours, tests their own words.
enum class ScriptRole { behavior, scenario, library, test };
SymbolTable symbol_table(ScriptRole role);

}  // namespace reorient
