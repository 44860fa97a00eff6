// SPDX-License-Identifier: MIT
// A state machine as data: what a script declared, before anything runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <lua.hpp>

#include "engine/script/source/lua_tokens.h"
#include "engine/world/names.h"

namespace reorient {

/// How long something must last: not at all, seconds, a parameter's value, or what a function says.
struct Dwell {
  enum class Kind { none, seconds, parameter, function };

  Kind kind = Kind::none;
  double seconds = 0.0;
  int index = 0;     ///< of the script's parameters, or the function's reference
  std::string text;  ///< for people: "0.5 s", "proof"
};

struct TransitionDefinition {
  int from = 0;        ///< state whose transition this is
  std::string target;  ///< as written
  int to = -1;
  int when = LUA_NOREF;  ///< function
  Dwell lasting;         ///< how long `when` must have held without a break
  Dwell after;           ///< how long since `from` was entered
  std::string because;   ///< the reason, never empty once validated
  NameId because_id = kNoName;
  bool common = false;    ///< checked before the others, and not while the target is active already
  std::string key;        ///< names it across reloads
  TextPosition position;  ///< in the file of `from`
  std::string maker;      ///< another file, one of whose functions made it; empty: it is written where it stands
};

struct StateDefinition {
  std::string name;
  std::string path;  ///< "outer/inner"; empty for the machine itself
  NameId path_id = kNoName;
  int parent = -1;
  std::vector<int> children;
  std::string initial_name;
  int initial = -1;      ///< child; -1: a state without children
  bool history = false;  ///< entering it resumes the child that was active last
  int enter = LUA_NOREF;
  int update = LUA_NOREF;
  int exit = LUA_NOREF;
  std::string publishes;  ///< what others may read while it is active; empty: nothing
  NameId publishes_id = kNoName;
  std::vector<int> transitions;  ///< `common` ones first
  std::string file;              ///< in which it is written: the machine's, or a library's
  TextPosition position;
};

/// Where a scenario takes place; what it leaves open is up to the run.
struct ScenarioSetting {
  std::string room;                        ///< panorama file; from the scripts' root, or the name of a shipped one
  std::optional<std::uint64_t> hall_seed;  ///< of a procedural hall; not together with a room
  std::string field;                       ///< as the room
};

struct MachineDefinition {
  std::string name;
  NameId name_id = kNoName;
  std::string file;
  TextPosition position;
  double priority = 0.0;
  bool is_scenario = false;
  std::vector<std::string> behaviors;   ///< that a scenario wants to be loaded
  ScenarioSetting setting;              ///< of a scenario
  std::vector<StateDefinition> states;  ///< the first is the machine itself; parents before children
  std::vector<TransitionDefinition> transitions;

  /// -1: there is no such state.
  int find(const std::string& path) const;
  bool is_within(int state, int ancestor) const;  ///< also where both are the same
};

/// A declaration that cannot be right, or is worth a look.
struct DeclarationError {
  TextPosition position;
  std::string message;
  std::string file{};  ///< empty: the one that is looked at
};

/// Gives every name in it its number.
void intern_names(MachineDefinition& machine, Names& names);

/// Resolves targets and initial states and fills in what is derived. All errors that were found, in file order.
std::vector<DeclarationError> resolve(MachineDefinition& machine);

}  // namespace reorient
