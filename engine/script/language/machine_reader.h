// From the tables of a `behavior` or `scenario` to a MachineDefinition.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <lua.hpp>

#include "engine/script/machine_definition.h"

namespace reorient {

/// Notes in the table at `table` that it is a state, with its name and line (stack indices of both).
void mark_state(lua_State* L, int table, int name, int line);

class MachineReader {
 public:
  /// `parameters`: full names of what `lasting` and `after` may refer to; `text`: the source, to find lines in.
  MachineReader(lua_State* L, MachineDefinition& machine, std::span<const std::string> parameters,
                std::string_view text);

  /// Reads the machine's table; throws std::runtime_error that begins with "file:line: ".
  void read(int table);

 private:
  void read_state(int table, int state);
  void read_items(int table, int state);
  void read_transition(int table, int state, bool always);
  void read_transitions(int table, int state);
  Dwell read_dwell(int table, const char* key);
  int read_function(int table, const char* key);
  std::string read_text(int table, const char* key);
  void read_behaviors(int table);
  void check_keys(int table, std::span<const char* const> known);
  int line_of(const std::string& target);
  [[noreturn]] void refuse(const std::string& message) const;

  lua_State* lua_;
  MachineDefinition& machine_;
  std::span<const std::string> parameters_;
  std::string_view text_;
  int line_ = 0;  ///< the state or transition that is being read
  int depth_ = 0;
};

}  // namespace reorient
