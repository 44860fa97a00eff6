// SPDX-License-Identifier: MIT
// From the tables of a `behavior` or `scenario` to a MachineDefinition.
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

/// Stack indices of what a state is called and where it is written.
struct StateMark {
  int name = 0;
  int line = 0;
  int file = 0;
};
/// Notes in the table at `table` that it is a state.
void mark_state(lua_State* L, int table, StateMark mark);

class MachineReader {
 public:
  /// `parameters`: full names of what `lasting` and `after` may refer to; `places_of`: the script's files. What is
  /// wrong is appended to `errors`; reading goes on, so that one look shows all.
  MachineReader(lua_State* L, MachineDefinition& machine, std::span<const std::string> parameters,
                const PlacesOf& places_of, std::vector<DeclarationError>& errors);

  /// Reads the machine's table, which Lua met in this line. Throws std::runtime_error where there is far too much.
  void read(int table, int line);

 private:
  /// The state or transition that is being read, and where it is written.
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
  Dwell read_dwell(int table, const char* key);
  int find_parameter(const std::string& name);
  int read_function(int table, const char* key);
  std::string read_text(int table, const char* key);
  std::string read_flag(int table);
  double read_priority(int table);
  void read_behaviors(int table);
  void read_setting(int table);
  void check_keys(int table, std::span<const char* const> known);
  /// Of the file that is being read.
  const SourceLocations& places();
  std::string maker_of(int transition);
  void note(const std::string& message) { errors_.push_back({here_.position, message, here_.file}); }
  /// At the key in question, where that is to be found.
  void note_at(const std::string& key, const std::string& message);

  lua_State* lua_;
  MachineDefinition& machine_;
  std::span<const std::string> parameters_;
  const PlacesOf& places_of_;
  std::map<std::string, const SourceLocations*> places_;  ///< those that were asked for: asking has its price
  std::vector<DeclarationError>& errors_;
  Here here_;
  int depth_ = 0;
};

}  // namespace reorient
