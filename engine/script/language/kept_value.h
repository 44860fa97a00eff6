// A script's `keep` memory outside of Lua: plain values, so that it survives a reload.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include <lua.hpp>

#include "geometry/bytes.h"

namespace reorient {

struct KeptValue;
using KeptKey = std::variant<lua_Integer, double, bool, std::string>;
using KeptTable = std::map<KeptKey, KeptValue>;

struct KeptValue {
  std::variant<bool, lua_Integer, double, std::string, KeptTable> value;

  /// Throws BadBytes where tables lie in each other deeper than read_kept() goes.
  template <typename Archive>
  void archive(Archive& archive) {
    if (archive.depth() > kDeepest) throw BadBytes("what a script keeps is too deep");
    const typename Archive::Level level(archive);
    archive(value);
  }
  static constexpr int kDeepest = 16;
};

/// The plain values of the table at `index`. What cannot be kept (functions, tables within themselves, more than the
/// `bytes` that are left, which are reduced) is left out; the first such keys are named in `left_out`.
KeptTable read_kept(lua_State* L, int index, std::size_t& bytes, std::vector<std::string>& left_out);

/// Writes kept values over the table at `index`. Where the table already has a value of another type, that one stays:
/// the script has changed its mind about what it keeps there.
void write_kept(lua_State* L, int index, const KeptTable& kept);

}  // namespace reorient
