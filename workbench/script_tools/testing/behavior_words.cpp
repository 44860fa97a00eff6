// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/behavior_words.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "workbench/scenario/scenario_language.h"

namespace reorient {
namespace {

struct MissingWord {
  std::string_view name;
  const char* instead;
};

constexpr std::array kMissing = {
    MissingWord{"behavior", "write it in a file below behaviors/, and load_behavior \"NAME\" loads it"},
    MissingWord{"scenario", "write it in a file below scenarios/, and load_scenario \"NAME\" loads it"},
    MissingWord{"state", "expect.state(\"MACHINE\", \"PATH\") checks the state of a machine"},
    MissingWord{"param", "set_param(\"NAME\", \"VALUE\") sets a parameter of a script"},
    MissingWord{"args", "load_behavior(\"NAME\", { x = 1.0 }) gives arguments"},
    MissingWord{"run", "load_behavior \"NAME\" runs a behavior, and the behaviors that it runs"},
    MissingWord{"done", "expect.state(\"CALLER/NAME\", \"PATH\") checks the state of a behavior that another one runs"},
    MissingWord{"failed",
                "expect.state(\"CALLER/NAME\", \"PATH\") checks the state of a behavior that another one runs"},
    MissingWord{"called",
                "expect.state(\"CALLER/NAME\", \"PATH\") checks the state of a behavior that another one runs"},
    MissingWord{"keep", "a local variable of the test keeps a value"},
    MissingWord{"behaviors", "expect.state(\"MACHINE\", \"PATH\") checks the state of a machine"},
    MissingWord{"published", "expect.state(\"MACHINE\", \"PATH\") checks the state that publishes it"},
    MissingWord{"time_in_state", "advance(SECONDS) lets time pass, and expect.state checks the state"},
    MissingWord{"command", "expect.command(\"NAME\") checks a command of a behavior"},
    MissingWord{"head", "expect.head(YAW, PITCH) checks the request of a behavior"},
    MissingWord{"walk", "expect.walk(FORWARD, LEFT, TURN) checks the request of a behavior"},
    MissingWord{"motion", "expect.get_up(true) checks the request of a behavior"},
    MissingWord{"input", "set_input { ball = { x = 1.0 } } sets values of the application"},
    MissingWord{"action", "expect.started(\"NAME\") checks a start of an action"},
    MissingWord{"application", "set_input and report_action play the application"},
    MissingWord{"team", "hear(SENDER, \"TEXT\") adds a message, and expect.message(\"TEXT\") checks one"},
    MissingWord{"log", "print(\"TEXT\") prints a line, and expect.log(\"TEXT\") checks one of a script"},
    MissingWord{"operator", "expect.action(\"NAME\") checks an action of the operator"},
    MissingWord{"verdict", "expect.verdict(true, \"TEXT\") checks the verdict of a scenario"},
    MissingWord{"truth", "set_world { truth = { x = 1 } } sets the true pose for a scenario"},
};

/// Arguments: the globals, a name that is not among them.
int refuse(lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING) return 0;
  const std::string_view name = lua_tostring(L, 2);
  const auto* const word =
      std::find_if(kMissing.begin(), kMissing.end(), [&](const auto& one) { return one.name == name; });
  if (word != kMissing.end())
    return luaL_error(L, "%s: a word of behaviors and scenarios, not of tests; %s", name.data(), word->instead);
  static const ScenarioLanguage language;
  const auto tables = language.tables();
  if (std::none_of(tables.begin(), tables.end(), [&](const WorldTable& one) { return one.name == name; })) return 0;
  return luaL_error(L,
                    "%s: a table of the world, which tests do not have; world_value(\"%s.FIELD\") reads a value, and "
                    "set_world sets it",
                    name.data(), name.data());
}

}  // namespace

void refuse_words_of_behaviors(lua_State* L) {
  lua_pushglobaltable(L);
  lua_createtable(L, 0, 2);
  lua_pushcfunction(L, refuse);
  lua_setfield(L, -2, "__index");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

}  // namespace reorient
