// SPDX-License-Identifier: MIT
// Converts the tables of a `behavior` or `scenario` to a MachineDefinition.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/source/source_locations.h"

namespace reorient {

/// Pushes the field of the table at `index`, without metamethods, and returns its type.
int raw_field(lua_State* L, int index, const char* name);

/// What a table of a machine declares, besides a transition.
enum class Marked { state, call };

/// Stack indices of a declaration's name and position.
struct Mark {
  int name = 0;
  int line = 0;
  int file = 0;
};
/// Marks the table at `table` as a state, or as a call of a behavior.
void mark(lua_State* L, int table, Marked what, Mark mark);

class MachineReader {
 public:
  /// `parameters`: full names for `lasting` and `after`; `body_parts`: names for `priority`; `places_of`: positions in
  /// the script's files. Appends errors to `errors` and continues, so that one run shows all.
  MachineReader(lua_State* L, MachineDefinition& machine, std::span<const std::string> parameters,
                std::span<const std::string> body_parts, const PlacesOf& places_of,
                std::vector<DeclarationError>& errors);

  /// Reads the machine's table, declared in this line. Throws std::runtime_error if it is far too large.
  void read(int table, int line);

 private:
  /// Position of the state or transition that is being read.
  struct Here {
    std::string file;
    TextPosition position;
    TextPosition end;
  };

  void read_state(int table, int state, SourceLocations::Table& place);
  void read_item(int item, int state, SourceLocations::Table& place);
  void read_inner_state(int item, int parent);
  void read_common(int table, int state, SourceLocations::Table& place);
  void read_transition(int table, int state, bool common, SourceLocations::Table& place);
  void read_call(int table, int state);
  void read_call_argument(CallDefinition& call);
  Dwell read_dwell(int table, const char* key);
  int find_parameter(const std::string& name);
  int read_function(int table, const char* key);
  std::string read_text(int table, const char* key);
  std::string read_flag(int table);
  BehaviorEnd read_end(int table);
  Priorities read_priorities(int table);
  void read_part_priorities(int table, Priorities& priorities);
  void read_behaviors(int table);
  void read_setting(int table);
  void check_keys(int table, std::span<const char* const> known);
  /// Of the file that is being read.
  const SourceLocations& places();
  std::string maker_of(int transition);
  void note(const std::string& message) { errors_.push_back({here_.position, message, here_.file}); }
  /// At the key's position if it is known.
  void note_at(const std::string& key, const std::string& message);

  lua_State* lua_;
  MachineDefinition& machine_;
  std::span<const std::string> parameters_;
  std::span<const std::string> body_parts_;
  const PlacesOf& places_of_;
  std::map<std::string, const SourceLocations*> places_;  ///< cache, because a look-up is expensive
  std::vector<DeclarationError>& errors_;
  Here here_;
  int depth_ = 0;
};

}  // namespace reorient
