// SPDX-License-Identifier: MIT
// A script's `keep` memory outside of Lua: plain values, which survive a reload.
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

  /// Throws BadBytes if tables are nested deeper than read_kept() reads.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    if (archive.depth() > kDeepest) throw BadBytes("kept value: nested too deeply");
    const typename Archive::Level level(archive);
    archive(self.value);
  }
  static constexpr int kDeepest = 16;
};

/// The plain values of the table at `index`, without those that cannot be stored (functions, recursive tables, more
/// than the remaining `bytes`; the size of each stored value is subtracted). `left_out` gets the first such keys.
KeptTable read_kept(lua_State* L, int index, std::size_t& bytes, std::vector<std::string>& left_out);

/// The part of `known` that is no longer in the table at `index`. A missing key has a plain value; a table that still
/// exists contains what is missing from it.
KeptTable removed_from(lua_State* L, int index, const KeptTable& known);
/// The same for a table with these values.
KeptTable removed_from(const KeptTable& values, const KeptTable& known);

/// Adds the keys that are missing in `known`.
void add_kept(KeptTable& known, const KeptTable& more);

enum class KeptFor { another_version, same_version };

/// Overwrites the table at `index` with kept values, and deletes the `removed` keys. If another version has a value of
/// another type, that value stays, because the script now stores something else there. A table with whole numbers as
/// keys is a list: either the kept one or the table's own, never a mixture.
void write_kept(lua_State* L, int index, const KeptTable& kept, const KeptTable& removed, KeptFor version);

}  // namespace reorient
