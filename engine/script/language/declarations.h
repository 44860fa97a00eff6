// The words with which a script declares itself: param, keep, state, behavior, scenario.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "engine/parameters/parameter.h"
#include "engine/script/machine_definition.h"

namespace reorient {

/// A `param` of a script: what was declared, and where its value lies in Lua.
struct DeclaredParameter {
  ParameterDeclaration declaration;  ///< named "file.name"
  std::string key;                   ///< "name"
  int values = LUA_NOREF;            ///< table in the registry
  double number = 0.0;               ///< the present value, for dwell times
};

/// A `keep` table, named by the file and its place there.
struct KeptMemory {
  std::string name;
  int table = LUA_NOREF;
};

class Declarations {
 public:
  /// `text_of` gives a loaded file's source, to find lines in; `preview` a parameter's value as it will be.
  Declarations(lua_State* L, bool is_scenario, std::function<std::string_view(const std::string&)> text_of,
               std::function<ParameterValue(const ParameterDeclaration&)> preview);

  /// From now on, declaring anything is an error.
  void close() { closed_ = true; }

  /// A deque: machines in use point to their definitions.
  std::deque<MachineDefinition> machines;
  std::vector<DeclaredParameter> parameters;
  std::vector<KeptMemory> memories;

  void set_value(DeclaredParameter& parameter, const ParameterValue& value);

 private:
  template <int (Declarations::*Method)(lua_State*)>
  static int bound(lua_State* L);
  template <int (Declarations::*Method)(lua_State*)>
  void add(const char* name);

  int param(lua_State* L);
  int keep(lua_State* L);
  int state(lua_State* L);
  int state_body(lua_State* L);
  int machine(lua_State* L);
  int machine_body(lua_State* L);

  void read_parameter(lua_State* L, const std::string& file, int line);
  ParameterDeclaration read_parameter_declaration(lua_State* L, const std::string& name);

  struct Reader;

  lua_State* lua_;
  bool is_scenario_;
  bool closed_ = false;
  std::function<std::string_view(const std::string&)> text_of_;
  std::function<ParameterValue(const ParameterDeclaration&)> preview_;
};

}  // namespace reorient
