// SPDX-License-Identifier: MIT
// A state machine as data, as declared by a script.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "engine/parameters/parameter.h"
#include "engine/script/machine/priorities.h"
#include "engine/script/source/lua_tokens.h"
#include "engine/world/names.h"
#include "geometry/const_or.h"

namespace reorient {

/// A dwell time: zero, seconds, a parameter's value, or the result of a function.
struct Dwell {
  enum class Kind { none, seconds, parameter, function };

  Kind kind = Kind::none;
  double seconds = 0.0;
  int index = 0;     ///< of the script's parameters, or the function's reference
  std::string text;  ///< for messages: "0.5 s", "proof"
};

struct TransitionDefinition {
  int from = 0;        ///< state whose transition this is
  std::string target;  ///< as written
  int to = -1;
  int when = LUA_NOREF;  ///< function
  std::string awaits;    ///< behavior whose end `when` awaits, as in `done "walk_to"`; empty: another function
  Dwell lasting;         ///< time for which `when` must have held without interruption
  Dwell after;           ///< time since `from` was entered
  std::string because;   ///< the reason, never empty once validated
  NameId because_id = kNoName;
  bool common = false;    ///< checked before the others, and not while the target is active already
  std::string key;        ///< identifies it across reloads
  TextPosition position;  ///< in the file of `from`
  std::string maker;      ///< file of the function that made it; empty: written in place
};

/// How a behavior ended, for the behavior that runs it.
enum class BehaviorEnd { none, done, failed };
constexpr int enum_count(BehaviorEnd) { return 3; }

/// "running", "done", "failed": the names in scripts.
std::string_view to_string(BehaviorEnd outcome);

/// An argument of a call: a value, or a function that the caller's script evaluates in every frame.
struct CallArgument {
  std::string name;
  ParameterValue value = 0.0;  ///< without a function
  int function = LUA_NOREF;
  TextPosition position;
};
/// Of one without a function.
template <typename Visit, ConstOr<CallArgument> T>
void fields(Visit&& visit, T& argument) {
  visit(argument.name, argument.value);
}

/// `run "walk_to" { ... }`: another behavior that runs while the state is active.
struct CallDefinition {
  int state = 0;
  std::string behavior;
  std::vector<CallArgument> arguments;
  TextPosition position;  ///< in the file of `state`
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
  BehaviorEnd ends = BehaviorEnd::none;  ///< the behavior has ended, once this state is active
  std::string publishes;                 ///< flag that scripts can read while it is active; empty: nothing
  NameId publishes_id = kNoName;
  std::vector<int> transitions;  ///< `common` ones first
  std::string file;              ///< of its text: the machine's, or a library's
  TextPosition position;
};

/// The setting of a scenario; the run decides what it does not specify.
struct ScenarioSetting {
  std::string room;                        ///< panorama file; from the scripts' root, or the name of a shipped one
  std::optional<std::uint64_t> hall_seed;  ///< of a procedural hall; not together with a room
  std::string field;                       ///< as the room
  std::string interface;                   ///< of the application that the scenario plays; as the room
};

struct MachineDefinition {
  std::string name;    ///< "walk_to"; of a behavior that another one runs, with its name: "striker/walk_to"
  std::string caller;  ///< name of the machine that runs this one; empty: it was loaded by name
  NameId name_id = kNoName;
  NameId left_id = kNoName;  ///< the reason for which a called machine stops
  std::string file;
  TextPosition position;
  Priorities priorities;  ///< of a called behavior, those of its caller
  bool is_scenario = false;
  std::vector<std::string> behaviors;   ///< requested by a scenario
  ScenarioSetting setting;              ///< of a scenario
  std::vector<StateDefinition> states;  ///< the first is the machine itself; parents before children
  std::vector<TransitionDefinition> transitions;
  std::vector<CallDefinition> calls;

  /// The name without those of its callers: "walk_to".
  std::string_view behavior() const { return std::string_view(name).substr(name.rfind('/') + 1); }
  /// -1: unknown state.
  int find(const std::string& path) const;
  bool is_within(int state, int ancestor) const;  ///< also where both are the same
};

/// An error or warning about a declaration.
struct DeclarationError {
  TextPosition position;
  std::string message;
  std::string file{};  ///< empty: the file being checked
};

/// Assigns numbers to all names.
void intern_names(MachineDefinition& machine, Names& names);

/// Resolves targets and initial states and fills in derived values. Returns all errors in file order.
std::vector<DeclarationError> resolve(MachineDefinition& machine);

}  // namespace reorient
