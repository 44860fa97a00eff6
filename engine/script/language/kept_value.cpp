// SPDX-License-Identifier: MIT
#include "engine/script/language/kept_value.h"

#include <optional>

namespace reorient {
namespace {

constexpr std::size_t kBytesPerValue = 64;  // approximate memory in Lua of a value or an empty table
constexpr std::size_t kMostNames = 20;      // of values that were left out

std::string describe_key(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TSTRING:
      return lua_tostring(L, index);
    case LUA_TNUMBER:
      return std::to_string(lua_tonumber(L, index));
    default:
      return lua_typename(L, lua_type(L, index));
  }
}

std::optional<KeptKey> read_key(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* text = lua_tolstring(L, index, &length);
      return std::string(text, length);
    }
    case LUA_TNUMBER:
      if (lua_isinteger(L, index) != 0) return lua_tointeger(L, index);
      return lua_tonumber(L, index);
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0;
    default:
      return std::nullopt;
  }
}

struct Reader {
  lua_State* L;
  std::size_t& bytes;
  std::vector<std::string>& left_out;

  /// False: a value with a text of this length exceeds the limit.
  bool pay(std::size_t length) {
    const std::size_t price = kBytesPerValue + length;
    if (price > bytes) return false;
    bytes -= price;
    return true;
  }

  static std::size_t length_of(lua_State* L, int index) {
    return lua_type(L, index) == LUA_TSTRING ? static_cast<std::size_t>(lua_rawlen(L, index)) : 0;
  }

  /// False: the value on top of the stack cannot be stored.
  bool value(int depth, KeptValue& kept) {
    // A text that occurs several times counts each time, because the stored values are copies.
    if (!pay(length_of(L, -1) + length_of(L, -2))) return false;
    if (lua_type(L, -1) == LUA_TTABLE) {
      if (depth >= KeptValue::kDeepest) return false;
      kept.value = table(-1, depth + 1);
      return true;
    }
    const std::optional<KeptKey> plain = read_key(L, -1);
    if (plain) std::visit([&kept](const auto& one) { kept.value = one; }, *plain);
    return plain.has_value();
  }

  KeptTable table(int index, int depth) {
    KeptTable kept;
    lua_checkstack(L, 4);
    const int absolute = lua_absindex(L, index);
    for (lua_pushnil(L); lua_next(L, absolute) != 0; lua_pop(L, 1)) {
      const std::optional<KeptKey> key = read_key(L, -2);
      KeptValue read;
      if (key && value(depth, read)) {
        kept.emplace(*key, std::move(read));
      } else if (left_out.size() < kMostNames) {
        left_out.push_back(describe_key(L, -2));
      }
    }
    return kept;
  }
};

void push_key(lua_State* L, const KeptKey& key) {
  if (const auto* whole = std::get_if<lua_Integer>(&key)) lua_pushinteger(L, *whole);
  if (const auto* number = std::get_if<double>(&key)) lua_pushnumber(L, *number);
  if (const auto* yes = std::get_if<bool>(&key)) lua_pushboolean(L, *yes ? 1 : 0);
  if (const auto* text = std::get_if<std::string>(&key)) lua_pushlstring(L, text->data(), text->size());
}

int type_of(const KeptValue& kept) {
  switch (kept.value.index()) {
    case 0:
      return LUA_TBOOLEAN;
    case 1:
    case 2:
      return LUA_TNUMBER;
    case 3:
      return LUA_TSTRING;
    default:
      return LUA_TTABLE;
  }
}

void push_plain(lua_State* L, const KeptValue& kept) {
  if (const auto* yes = std::get_if<bool>(&kept.value)) lua_pushboolean(L, *yes ? 1 : 0);
  if (const auto* whole = std::get_if<lua_Integer>(&kept.value)) lua_pushinteger(L, *whole);
  if (const auto* number = std::get_if<double>(&kept.value)) lua_pushnumber(L, *number);
  if (const auto* text = std::get_if<std::string>(&kept.value)) lua_pushlstring(L, text->data(), text->size());
}

bool is_in_list(const KeptKey& key) { return std::holds_alternative<lua_Integer>(key); }

/// Whole numbers are the first among the keys.
bool has_list(const KeptTable& table) { return !table.empty() && is_in_list(table.begin()->first); }

const KeptTable& table_at(const KeptTable& table, const KeptKey& key) {
  static const KeptTable none;
  const auto found = table.find(key);
  const auto* const inner = found == table.end() ? nullptr : std::get_if<KeptTable>(&found->second.value);
  return inner == nullptr ? none : *inner;
}

void remove_key(lua_State* L, int table, const KeptKey& key) {
  push_key(L, key);
  lua_pushnil(L);
  lua_rawset(L, table);
}

/// The types of the elements, as bits.
unsigned list_types(lua_State* L, int table) {
  unsigned types = 0;
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_isinteger(L, -2) != 0) types |= 1u << lua_type(L, -1);
  }
  return types;
}

unsigned list_types(const KeptTable& kept) {
  unsigned types = 0;
  for (const auto& [key, value] : kept) {
    if (is_in_list(key)) types |= 1u << type_of(value);
  }
  return types;
}

/// Whether the stored list replaces the list at `table`: not if the script now has elements of other types there.
bool takes_list(lua_State* L, int table, const KeptTable& kept, const KeptTable& removed, KeptFor version) {
  if (!has_list(kept) && !has_list(removed)) return false;
  if (version == KeptFor::same_version) return true;
  const unsigned before = list_types(kept);
  const unsigned now = list_types(L, table);
  return before == 0 || now == 0 || (before & now) != 0;
}

/// Removes what is not in the stored list. Lua allows setting fields to nil while iterating over a table.
void shorten_list(lua_State* L, int table, const KeptTable& kept) {
  for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
    if (lua_isinteger(L, -2) == 0) continue;
    const KeptKey key = lua_tointeger(L, -2);
    if (!kept.contains(key)) remove_key(L, table, key);
  }
}

void remove_keys(lua_State* L, int table, const KeptTable& removed) {
  for (const auto& [key, value] : removed) {
    if (!is_in_list(key) && !std::holds_alternative<KeptTable>(value.value)) remove_key(L, table, key);
  }
}

}  // namespace

KeptTable read_kept(lua_State* L, int index, std::size_t& bytes, std::vector<std::string>& left_out) {
  return Reader{L, bytes, left_out}.table(index, 0);
}

KeptTable removed_from(lua_State* L, int index, const KeptTable& known) {
  lua_checkstack(L, 4);
  const int table = lua_absindex(L, index);
  KeptTable removed;
  for (const auto& [key, value] : known) {
    push_key(L, key);
    const int present = lua_rawget(L, table);
    const auto* const inner = std::get_if<KeptTable>(&value.value);
    if (present == LUA_TNIL) removed[key] = {true};
    if (present == LUA_TTABLE && inner != nullptr) removed[key] = {removed_from(L, -1, *inner)};
    lua_pop(L, 1);
  }
  return removed;
}

KeptTable removed_from(const KeptTable& values, const KeptTable& known) {
  KeptTable removed;
  for (const auto& [key, value] : known) {
    const auto present = values.find(key);
    const auto* const inner = std::get_if<KeptTable>(&value.value);
    if (present == values.end()) removed[key] = {true};
    if (present != values.end() && inner != nullptr) removed[key] = {removed_from(table_at(values, key), *inner)};
  }
  return removed;
}

void add_kept(KeptTable& known, const KeptTable& more) {
  for (const auto& [key, value] : more) {
    KeptValue& there = known.try_emplace(key, value).first->second;
    auto* const inner = std::get_if<KeptTable>(&there.value);
    if (inner != nullptr) add_kept(*inner, table_at(more, key));
  }
}

void write_kept(lua_State* L, int index, const KeptTable& kept, const KeptTable& removed, KeptFor version) {
  lua_checkstack(L, 6);
  const int table = lua_absindex(L, index);
  const bool with_list = takes_list(L, table, kept, removed, version);
  if (with_list) shorten_list(L, table, kept);
  remove_keys(L, table, removed);
  for (const auto& [key, value] : kept) {
    const bool is_taken = version == KeptFor::same_version || (with_list && is_in_list(key));
    if (is_in_list(key) && !with_list) continue;
    push_key(L, key);
    lua_pushvalue(L, -1);
    const int present = lua_rawget(L, table);
    if (present != LUA_TNIL && present != type_of(value) && !is_taken) {
      lua_pop(L, 2);
      continue;
    }
    if (const auto* inner = std::get_if<KeptTable>(&value.value)) {
      if (present != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
      }
      write_kept(L, -1, *inner, table_at(removed, key), version);
    } else {
      lua_pop(L, 1);
      push_plain(L, value);
    }
    lua_rawset(L, table);
  }
}

}  // namespace reorient
