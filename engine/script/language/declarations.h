// SPDX-License-Identifier: MIT
// The functions of declarations in scripts: param, args, keep, state, run, behavior, scenario.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include <lua.hpp>

#include "engine/parameters/parameter.h"
#include "engine/script/machine/machine_definition.h"
#include "engine/script/sandbox/sandbox.h"
#include "engine/script/source/source_locations.h"

namespace reorient {

/// A `param` of a script or one of its `args`: its declaration, and where Lua stores its value.
struct DeclaredParameter {
  ParameterDeclaration declaration;  ///< named "file.name"; an argument: "args.name"
  std::string key;                   ///< "name"
  int values = LUA_NOREF;            ///< table in the registry
  bool is_argument = false;          ///< its caller sets it, and nothing else
  double number = 0.0;               ///< current value, for dwell times
};

/// A `keep` table, named by its file and its position in it.
struct KeptMemory {
  std::string name;
  int table = LUA_NOREF;
};

class Declarations {
 public:
  using Preview = std::function<ParameterValue(const ParameterDeclaration&)>;

  /// `body_parts`: those for which a machine may have priorities; `places_of`: positions of a loaded file's
  /// declarations; `preview`: the value that a parameter will get.
  Declarations(lua_State* L, bool is_scenario, std::vector<std::string> body_parts, PlacesOf places_of,
               Preview preview);

  /// From now on, declaring anything is an error.
  void close() { closed_ = true; }

  /// A deque: machines in use point to their definitions.
  std::deque<MachineDefinition> machines;
  std::vector<DeclaredParameter> parameters;
  std::vector<KeptMemory> memories;
  std::vector<ScriptFault> faults;  ///< the errors of all declarations

  void set_value(DeclaredParameter& parameter, const ParameterValue& value);

 private:
  template <int (Declarations::*Method)(lua_State*)>
  static int bound(lua_State* L);
  template <int (Declarations::*Method)(lua_State*)>
  void add(const char* name);

  int param(lua_State* L);
  int args(lua_State* L);
  int keep(lua_State* L);
  int state(lua_State* L);
  int state_body(lua_State* L);
  int run(lua_State* L);
  int run_body(lua_State* L);
  int machine(lua_State* L);
  int machine_body(lua_State* L);

  /// What declares parameters: a `param` or an `args`.
  struct Source {
    const char* word;
    std::string file;
    int line;
    std::string prefix;  ///< of the names
    bool is_argument;
  };
  int read_parameters(lua_State* L, const Source& source);
  void read_parameter(lua_State* L, const Source& source);
  /// Pushes what `name "text"` returns: a function that takes the table that follows.
  template <int (Declarations::*Body)(lua_State*)>
  int await_table(lua_State* L);
  ParameterDeclaration read_parameter_declaration(lua_State* L, const std::string& name);

  /// Adds errors to `faults`. The script continues, so that its other errors are found, too.
  void note(const std::string& file, std::vector<DeclarationError> errors);

  lua_State* lua_;
  bool is_scenario_;
  std::vector<std::string> body_parts_;
  bool closed_ = false;
  PlacesOf places_of_;
  Preview preview_;
  std::vector<std::string> refused_;  ///< names of parameters with errors
};

}  // namespace reorient
