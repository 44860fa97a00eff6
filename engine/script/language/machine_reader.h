// From the tables of a `behavior` or `scenario` to a MachineDefinition.
#pragma once

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

/// Notes in the table at `table` that it is a state, with its name and line (stack indices of both).
void mark_state(lua_State* L, int table, int name, int line);

class MachineReader {
 public:
  /// `parameters`: full names of what `lasting` and `after` may refer to; `places`: of the machine's file. What is
  /// wrong is appended to `errors`; reading goes on, so that one look shows all.
  MachineReader(lua_State* L, MachineDefinition& machine, std::span<const std::string> parameters,
                const SourceLocations& places, std::vector<DeclarationError>& errors);

  /// Reads the machine's table, which Lua met in this line. Throws std::runtime_error where there is far too much.
  void read(int table, int line);

 private:
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
  void note(const std::string& message) { errors_.push_back({position_, message}); }
  /// At the key in question, where that is to be found.
  void note_at(const std::string& key, const std::string& message);

  lua_State* lua_;
  MachineDefinition& machine_;
  std::span<const std::string> parameters_;
  const SourceLocations& places_;
  std::vector<DeclarationError>& errors_;
  TextPosition position_;  ///< of the state or transition that is being read
  TextPosition end_;       ///< where it ends
  int depth_ = 0;
};

}  // namespace reorient
