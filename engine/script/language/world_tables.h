// The world in one script's Lua: read-only tables that are refreshed each frame and refuse names that do not exist.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <lua.hpp>

namespace reorient {

class WorldTables {
 public:
  /// Makes the tables as globals of `L`; scenarios also get `truth`.
  WorldTables(lua_State* L, bool for_scenario);

  /// Writes what changed since the last call; `values` as read_world() gives them.
  void refresh(const std::vector<double>& values);

 private:
  struct Shown {
    std::size_t field = 0;  ///< index into world_fields()
    int table = 0;          ///< of the values, in the registry
    const char* name = "";
    bool is_boolean = false;
    double value = 0.0;
  };

  lua_State* lua_;
  std::vector<Shown> shown_;
};

/// Makes the table on top of the stack read-only: it is replaced by an empty table through which its fields are seen.
/// `what` names it in errors ("robot"). A field that is not there is an error, with "did you mean".
void make_read_only(lua_State* L, const std::string& what);

}  // namespace reorient
