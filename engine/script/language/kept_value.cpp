#include "engine/script/language/kept_value.h"

#include <optional>

namespace reorient {
namespace {

constexpr std::size_t kBytesPerValue = 64;  // about what Lua needs for one, or for an empty table
constexpr std::size_t kMostNames = 20;      // of what was left out

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

  /// False: there is no room left for a value with so long a text.
  bool pay(std::size_t length) {
    const std::size_t price = kBytesPerValue + length;
    if (price > bytes) return false;
    bytes -= price;
    return true;
  }

  static std::size_t length_of(lua_State* L, int index) {
    return lua_type(L, index) == LUA_TSTRING ? static_cast<std::size_t>(lua_rawlen(L, index)) : 0;
  }

  /// False: the value at the stack's top cannot be kept.
  bool value(int depth, KeptValue& kept) {
    // Also a text that stands in many places is paid for in each: what is kept are copies.
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

}  // namespace

KeptTable read_kept(lua_State* L, int index, std::size_t& bytes, std::vector<std::string>& left_out) {
  return Reader{L, bytes, left_out}.table(index, 0);
}

void write_kept(lua_State* L, int index, const KeptTable& kept) {
  lua_checkstack(L, 6);
  const int table = lua_absindex(L, index);
  for (const auto& [key, value] : kept) {
    push_key(L, key);
    lua_pushvalue(L, -1);
    const int present = lua_rawget(L, table);
    if (present != LUA_TNIL && present != type_of(value)) {
      lua_pop(L, 2);
      continue;
    }
    if (const auto* inner = std::get_if<KeptTable>(&value.value)) {
      if (present == LUA_TNIL) {
        lua_pop(L, 1);
        lua_newtable(L);
      }
      write_kept(L, -1, *inner);
    } else {
      lua_pop(L, 1);
      if (const auto* yes = std::get_if<bool>(&value.value)) lua_pushboolean(L, *yes ? 1 : 0);
      if (const auto* whole = std::get_if<lua_Integer>(&value.value)) lua_pushinteger(L, *whole);
      if (const auto* number = std::get_if<double>(&value.value)) lua_pushnumber(L, *number);
      if (const auto* text = std::get_if<std::string>(&value.value)) lua_pushlstring(L, text->data(), text->size());
    }
    lua_rawset(L, table);
  }
}

}  // namespace reorient
