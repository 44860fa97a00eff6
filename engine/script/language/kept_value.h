// SPDX-License-Identifier: MIT
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
  static void archive(Archive& archive, auto& self) {
    if (archive.depth() > kDeepest) throw BadBytes("what a script keeps is too deep");
    const typename Archive::Level level(archive);
    archive(self.value);
  }
  static constexpr int kDeepest = 16;
};

/// The plain values of the table at `index`. What cannot be kept (functions, tables within themselves, more than the
/// `bytes` that are left, which are reduced) is left out; the first such keys are named in `left_out`.
KeptTable read_kept(lua_State* L, int index, std::size_t& bytes, std::vector<std::string>& left_out);

/// Of what was known to be in the table at `index`: what is no longer there. A key that is gone has a plain value; a
/// table that is still there holds what is gone from it.
KeptTable gone_from(lua_State* L, int index, const KeptTable& known);
/// The same, of a table that holds these values.
KeptTable gone_from(const KeptTable& values, const KeptTable& known);

/// Adds what is not there yet.
void add_kept(KeptTable& known, const KeptTable& more);

enum class KeptFor { another_version, same_version };

/// Writes kept values over the table at `index`, and takes out of it what is gone. Where another version has a value of
/// another type, that one stays: the script has changed its mind about what it keeps there. What has whole numbers as
/// keys is a list, which is the kept one or the table's own, never a mixture.
void write_kept(lua_State* L, int index, const KeptTable& kept, const KeptTable& gone, KeptFor whom);

}  // namespace reorient
