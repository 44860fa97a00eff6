// SPDX-License-Identifier: MIT
// string.find, match, gmatch, gsub, rep and format for scripts, with the costs of pattern.h and a limited result.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/script/sandbox/pattern.h"
#include "engine/script/sandbox/safe_library.h"
#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

std::string_view text_at(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(L, index, &length);
  return {text, length};
}

int too_long(lua_State* L) {
  return luaL_error(L, "string too long (expected at most %d bytes)", static_cast<int>(Sandbox::of(L).string_length()));
}

/// Lua's "init": from 1, negative ones count from the end. In [0, size]; beyond: size + 1.
std::size_t start_of(lua_State* L, int index, std::size_t size) {
  const lua_Integer init = luaL_optinteger(L, index, 1);
  const auto length = static_cast<lua_Integer>(size);
  if (init > 0) return static_cast<std::size_t>(std::min(init - 1, length + 1));
  if (init == 0 || init < -length) return 0;
  return static_cast<std::size_t>(length + init);
}

/// Searches and charges the budget; a malformed or too expensive pattern is a Lua error.
std::optional<Pattern::Match> search(lua_State* L, std::string_view subject, std::string_view pattern,
                                     std::size_t from) {
  Sandbox& sandbox = Sandbox::of(L);
  constexpr std::int64_t kPrice = 2;  // instructions for one step
  const std::int64_t granted = std::max<std::int64_t>(sandbox.remaining(), 0) / kPrice;
  std::int64_t steps = granted;
  std::string failure;
  std::optional<Pattern::Match> match;
  try {
    match = Pattern(pattern).search(subject, from, steps);
  } catch (const PatternError& error) {
    failure = error.what();
  } catch (const PatternTooCostly&) {
    steps = -1;
  }
  sandbox.charge(kPrice * (granted - steps) + static_cast<std::int64_t>(pattern.size()));
  if (!failure.empty()) luaL_error(L, "%s", failure.c_str());
  return match;
}

void push_capture(lua_State* L, std::string_view subject, const Pattern::Capture& capture) {
  if (capture.is_position) {
    lua_pushinteger(L, static_cast<lua_Integer>(capture.start) + 1);
  } else {
    const std::string_view text = subject.substr(capture.start, capture.length);
    lua_pushlstring(L, text.data(), text.size());
  }
}

int push_captures(lua_State* L, std::string_view subject, const Pattern::Match& match, bool whole_if_none) {
  luaL_checkstack(L, static_cast<int>(match.captures.size()) + 1, "too many captures");
  for (const Pattern::Capture& capture : match.captures) push_capture(L, subject, capture);
  if (!match.captures.empty() || !whole_if_none) return static_cast<int>(match.captures.size());
  push_capture(L, subject, {match.begin, match.end - match.begin, true, false});
  return 1;
}

int find_or_match(lua_State* L, bool find) {
  const std::string_view subject = text_at(L, 1);
  const std::string_view pattern = text_at(L, 2);
  const std::size_t from = start_of(L, 3, subject.size());
  if (from > subject.size()) {
    lua_pushnil(L);
    return 1;
  }
  const bool is_plain = pattern.find_first_of("^$*+?.([%-") == std::string_view::npos;
  if (find && (is_plain || lua_toboolean(L, 4) != 0)) {
    Sandbox::of(L).charge(static_cast<std::int64_t>(subject.size() * (pattern.size() + 1) / 64));
    const std::size_t found = subject.find(pattern, from);
    if (found == std::string_view::npos) {
      lua_pushnil(L);
      return 1;
    }
    lua_pushinteger(L, static_cast<lua_Integer>(found) + 1);
    lua_pushinteger(L, static_cast<lua_Integer>(found + pattern.size()));
    return 2;
  }
  const std::optional<Pattern::Match> match = search(L, subject, pattern, from);
  if (!match) {
    lua_pushnil(L);
    return 1;
  }
  if (!find) return push_captures(L, subject, *match, true);
  lua_pushinteger(L, static_cast<lua_Integer>(match->begin) + 1);
  lua_pushinteger(L, static_cast<lua_Integer>(match->end));
  return 2 + push_captures(L, subject, *match, false);
}

int safe_find(lua_State* L) { return find_or_match(L, true); }
int safe_match(lua_State* L) { return find_or_match(L, false); }

/// Upvalues: subject, pattern, start of the next search, end of the previous match (0: none).
int next_match(lua_State* L) {
  const std::string_view subject = text_at(L, lua_upvalueindex(1));
  const std::string_view pattern = text_at(L, lua_upvalueindex(2));
  auto from = static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(3)));
  const lua_Integer last_end = lua_tointeger(L, lua_upvalueindex(4));
  while (from <= subject.size()) {
    const std::optional<Pattern::Match> match = search(L, subject, pattern, from);
    if (!match) break;
    if (match->begin == match->end && static_cast<lua_Integer>(match->end) + 1 == last_end) {
      from = match->end + 1;  // an empty match directly after the previous one does not count
      continue;
    }
    lua_pushinteger(L, static_cast<lua_Integer>(match->end));
    lua_replace(L, lua_upvalueindex(3));
    lua_pushinteger(L, static_cast<lua_Integer>(match->end) + 1);
    lua_replace(L, lua_upvalueindex(4));
    return push_captures(L, subject, *match, true);
  }
  lua_pushinteger(L, static_cast<lua_Integer>(subject.size()) + 1);
  lua_replace(L, lua_upvalueindex(3));
  lua_pushnil(L);
  return 1;
}

int safe_gmatch(lua_State* L) {
  const std::string_view subject = text_at(L, 1);
  const std::string_view pattern = text_at(L, 2);
  if (pattern.starts_with('^')) return luaL_argerror(L, 2, "gmatch: anchor '^' is not supported");
  const std::size_t from = start_of(L, 3, subject.size());
  lua_settop(L, 2);
  lua_pushinteger(L, static_cast<lua_Integer>(from));
  lua_pushinteger(L, 0);
  lua_pushcclosure(L, next_match, 4);
  return 1;
}

/// Appends to a text. Checks the limit of length and charges each part.
void append(lua_State* L, std::string& out, std::string_view part) {
  constexpr std::size_t kLettersPerInstruction = 16;
  Sandbox& sandbox = Sandbox::of(L);
  if (out.size() + part.size() > sandbox.string_length()) too_long(L);
  sandbox.charge(static_cast<std::int64_t>(1 + part.size() / kLettersPerInstruction));
  out += part;
}

void append_capture(lua_State* L, std::string& out, std::string_view subject, const Pattern::Capture& capture) {
  if (capture.is_position) {
    append(L, out, std::to_string(capture.start + 1));
  } else {
    append(L, out, subject.substr(capture.start, capture.length));
  }
}

/// A replacement text with %0 ... %9 and %%.
void expand(lua_State* L, std::string& out, std::string_view subject, std::string_view text,
            const Pattern::Match& match) {
  while (!text.empty()) {
    const std::size_t plain = std::min(text.find('%'), text.size());
    append(L, out, text.substr(0, plain));
    text.remove_prefix(plain);
    if (text.empty()) return;
    const char letter = text.size() > 1 ? text[1] : '\0';
    if (letter == '%') {
      append(L, out, "%");
    } else if (letter == '0' || (letter == '1' && match.captures.empty())) {
      append(L, out, subject.substr(match.begin, match.end - match.begin));
    } else if (letter >= '1' && letter <= '9' && static_cast<std::size_t>(letter - '1') < match.captures.size()) {
      append_capture(L, out, subject, match.captures[static_cast<std::size_t>(letter - '1')]);
    } else {
      luaL_error(L, "invalid use of '%%' in the replacement text");
    }
    text.remove_prefix(2);
  }
}

/// The replacement of a match: a text's expansion, a table's field, a function's result; false and nil: the match.
void replace(lua_State* L, std::string& out, std::string_view subject, const Pattern::Match& match) {
  if (lua_type(L, 3) != LUA_TTABLE && lua_type(L, 3) != LUA_TFUNCTION) {
    expand(L, out, subject, text_at(L, 3), match);
    return;
  }
  if (lua_type(L, 3) == LUA_TFUNCTION) {
    lua_pushvalue(L, 3);
    lua_call(L, push_captures(L, subject, match, true), 1);
  } else {
    const int captures = push_captures(L, subject, match, true);
    lua_pop(L, captures - 1);
    lua_gettable(L, 3);
  }
  if (lua_toboolean(L, -1) == 0) {
    append(L, out, subject.substr(match.begin, match.end - match.begin));
  } else if (lua_isstring(L, -1) != 0) {
    append(L, out, text_at(L, -1));
  } else {
    luaL_error(L, "invalid replacement value of type %s (expected a string or a number)", luaL_typename(L, -1));
  }
  lua_pop(L, 1);
}

int safe_gsub(lua_State* L) {
  const std::string_view subject = text_at(L, 1);
  const std::string_view pattern = text_at(L, 2);
  const int kind = lua_type(L, 3);
  const bool usable = kind == LUA_TSTRING || kind == LUA_TNUMBER || kind == LUA_TTABLE || kind == LUA_TFUNCTION;
  if (!usable) return luaL_argerror(L, 3, "string, table or function expected");
  const lua_Integer most = luaL_optinteger(L, 4, static_cast<lua_Integer>(subject.size()) + 1);
  std::string out;
  lua_Integer count = 0;
  std::size_t at = 0;    // everything before is in `out`
  std::size_t from = 0;  // where to search
  while (count < most && from <= subject.size()) {
    const std::optional<Pattern::Match> match = search(L, subject, pattern, from);
    if (!match) break;
    const bool empty_again = count > 0 && match->begin == match->end && match->begin == at && from == at;
    if (empty_again) {
      if (pattern.starts_with('^')) break;
      from = at + 1;
      continue;
    }
    append(L, out, subject.substr(at, match->begin - at));
    replace(L, out, subject, *match);
    ++count;
    at = match->end;
    from = match->end;
    if (pattern.starts_with('^')) break;
  }
  append(L, out, subject.substr(at));
  lua_pushlstring(L, out.data(), out.size());
  lua_pushinteger(L, count);
  return 2;
}

int safe_rep(lua_State* L) {
  const std::string_view text = text_at(L, 1);
  const lua_Integer count = luaL_checkinteger(L, 2);
  const std::string_view separator = lua_isnoneornil(L, 3) ? std::string_view() : text_at(L, 3);
  const std::size_t each = text.size() + separator.size();
  if (count <= 0 || each == 0) {
    lua_pushliteral(L, "");
    return 1;
  }
  const std::size_t longest = Sandbox::of(L).string_length();
  if (static_cast<std::size_t>(count) > longest ||
      each * static_cast<std::size_t>(count) > longest + separator.size()) {
    return too_long(L);
  }
  std::string out;
  out.reserve(each * static_cast<std::size_t>(count));
  for (lua_Integer i = 0; i < count; ++i) {
    if (i > 0) out += separator;
    out += text;
  }
  lua_pushlstring(L, out.data(), out.size());
  return 1;
}

/// Upvalue: Lua's own format, which gets texts instead of tables (which would show addresses) and never %p.
int safe_format(lua_State* L) {
  const std::string_view format = text_at(L, 1);
  for (std::size_t i = 0; i + 1 < format.size(); ++i) {
    if (format[i] != '%') continue;
    i = format.find_first_not_of("-+ #0123456789.", i + 1);
    if (i == std::string_view::npos) break;
    if (format[i] == 'p') return luaL_argerror(L, 1, "%p would show an address");
  }
  const int count = lua_gettop(L);
  for (int index = 2; index <= count; ++index) {
    const int type = lua_type(L, index);
    if (type != LUA_TTABLE && type != LUA_TFUNCTION && type != LUA_TUSERDATA) continue;
    push_text(L, index);
    lua_replace(L, index);
  }
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, count, 1);
  // The time to write a number grows with the square of its digits.
  constexpr std::int64_t kMostDigits = 512;
  const auto length = std::min(static_cast<std::int64_t>(lua_rawlen(L, -1)), kMostDigits);
  Sandbox::of(L).charge(length * length / 64);
  return 1;
}

}  // namespace

void add_safe_strings(lua_State* L) {
  constexpr luaL_Reg kFunctions[] = {{"find", safe_find}, {"match", safe_match}, {"gmatch", safe_gmatch},
                                     {"gsub", safe_gsub}, {"rep", safe_rep},     {nullptr, nullptr}};
  luaL_setfuncs(L, kFunctions, 0);
  lua_getfield(L, LUA_REGISTRYINDEX, "format");
  lua_pushcclosure(L, safe_format, 1);
  lua_setfield(L, -2, "format");
}

}  // namespace reorient
