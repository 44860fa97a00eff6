// SPDX-License-Identifier: MIT
// The fields and functions of one type of script, declared once: the bindings, the reference page, the checks and
// the editor annotations are generated from it.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <lua.hpp>

#include "engine/script/language/script_actions.h"
#include "engine/script/sandbox/binding.h"

namespace reorient {

enum class ScriptKind { behavior, scenario };
constexpr int enum_count(ScriptKind) { return 2; }

/// A field of a table of the world.
struct WorldField {
  enum class Type { number, boolean, name };

  std::string_view table;        ///< "robot"
  std::string_view name;         ///< "posture"
  std::string_view unit;         ///< "m", or empty
  std::string_view description;  ///< one phrase with quantity and effect
  Type type = Type::number;
  std::span<const std::string_view> names;                    ///< possible values of a name; its number is the index
  double minimum = -std::numeric_limits<double>::infinity();  ///< of a number
  double maximum = std::numeric_limits<double>::infinity();
  bool is_integer = false;            ///< of a number
  std::string_view replacement = {};  ///< of a former name, which scripts may still use: the new field

  std::string full_name() const { return std::string(table) + "." + std::string(name); }
  std::string_view type_name() const {
    return type == Type::number ? "number" : type == Type::boolean ? "boolean" : "string";
  }
};

struct WorldTable {
  std::string_view name;
  std::string_view description;
};

struct ArgumentDoc {
  std::string name;
  std::string type;  ///< "number", "boolean", "string"; with a "?" if it is optional
};

struct ScriptFunction {
  std::string table;  ///< "command"; empty: a global function
  std::string name;
  lua_CFunction call = nullptr;
  void* (*object)(ScriptActions&) = nullptr;  ///< what `call` is bound to
  std::vector<ArgumentDoc> arguments;
  std::string result;       ///< type, or empty
  std::string description;  ///< with the units of its arguments

  std::string full_name() const { return table.empty() ? name : table + "." + name; }
};

/// Former name of a table of functions: scripts may use both names.
struct FormerTable {
  std::string_view name;
  std::string_view replacement;
};

/// Implemented for behaviors, and in the workbench for scenarios.
class ScriptLanguage {
 public:
  virtual ~ScriptLanguage() = default;

  virtual ScriptKind kind() const = 0;
  /// The folder below the scripts' root in which a name is searched.
  virtual std::string_view folder() const = 0;
  virtual std::span<const WorldTable> tables() const = 0;
  virtual std::span<const WorldField> world() const = 0;
  virtual std::span<const ScriptFunction> functions() const = 0;
  virtual std::span<const FormerTable> former_tables() const { return {}; }
  /// Names of the parts of the body for which its machines may have priorities.
  virtual std::vector<std::string> body_parts() const { return {}; }
  /// Makes further globals of a script's Lua; the language must outlive it.
  virtual void add_globals(lua_State* /*L*/) {}
  virtual ScriptActions& actions() = 0;
};

/// "behavior", "scenario": the function with which such a script declares a machine.
std::string_view to_string(ScriptKind kind);

/// Makes the functions as globals of `L`.
void add_script_functions(lua_State* L, ScriptLanguage& language);

namespace detail {

template <typename T>
struct TypeName {
  static std::string of() { return std::string(lua::Value<T>::name); }
};
template <typename T>
struct TypeName<std::optional<T>> {
  static std::string of() { return TypeName<T>::of() + "?"; }
};

template <typename Self, typename Result, typename... Arguments>
void describe_types(Result (Self::*)(Arguments...), ScriptFunction& function) {
  const std::vector<std::string> types{TypeName<Arguments>::of()...};
  for (std::size_t i = 0; i < types.size(); ++i) function.arguments.at(i).type = types[i];
  if constexpr (!std::is_void_v<Result>) function.result = TypeName<Result>::of();
  function.object = [](ScriptActions& actions) -> void* { return static_cast<Self*>(&actions); };
}

}  // namespace detail

/// A member function of some ScriptActions as a function of scripts. `name` is "table.name" or a global's name.
template <auto Method>
ScriptFunction script_function(const std::string& name, const std::vector<const char*>& arguments,
                               const char* description) {
  ScriptFunction function;
  const std::size_t dot = name.find('.');
  if (dot != std::string::npos) function.table = name.substr(0, dot);
  function.name = dot == std::string::npos ? name : name.substr(dot + 1);
  function.call = &lua::Bound<Method>::call;
  for (const char* argument : arguments) function.arguments.push_back({argument, ""});
  detail::describe_types(Method, function);
  function.description = description;
  return function;
}

/// The same for a member function that reads its arguments from the stack itself: int (Self::*)(lua_State*).
template <typename Self, int (Self::*Method)(lua_State*)>
ScriptFunction raw_script_function(const char* table, const char* name, std::vector<ArgumentDoc> arguments,
                                   const char* result, const char* description) {
  ScriptFunction function{table,  name,       &lua::RawBound<Method>::call, nullptr, std::move(arguments),
                          result, description};
  function.object = [](ScriptActions& actions) -> void* { return static_cast<Self*>(&actions); };
  return function;
}

}  // namespace reorient
