// SPDX-License-Identifier: MIT
// Arbitrary string patterns and subjects: each search is charged for its steps, captures lie within the subject, and
// the match is that of Lua's own matcher. The input is the pattern, a byte 0xFF, the subject.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <lua.hpp>

#include "engine/script/sandbox/pattern.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

constexpr std::int64_t kSteps = 20'000;
constexpr std::int64_t kDearest = 1'024;    // largest number of steps of the last operation before the end
constexpr std::size_t kLongestForLua = 48;  // bytes of pattern and subject, because Lua's own search is not bounded

/// The result of Lua's string.find: begin and end, counted as in Pattern; nothing if the pattern is malformed for Lua.
struct LuasAnswer {
  bool malformed = false;
  std::optional<std::pair<std::size_t, std::size_t>> match;
};

LuasAnswer ask_lua(std::string_view subject, std::string_view pattern) {
  static lua_State* const L = [] {
    lua_State* const state = luaL_newstate();
    luaL_openlibs(state);
    return state;
  }();
  LuasAnswer answer;
  lua_settop(L, 0);
  lua_getglobal(L, "string");
  lua_getfield(L, -1, "find");
  lua_pushlstring(L, subject.data(), subject.size());
  lua_pushlstring(L, pattern.data(), pattern.size());
  if (lua_pcall(L, 2, 2, 0) != LUA_OK) {
    answer.malformed = true;
  } else if (!lua_isnil(L, -2)) {
    answer.match = {static_cast<std::size_t>(lua_tointeger(L, -2)) - 1, static_cast<std::size_t>(lua_tointeger(L, -1))};
  }
  return answer;
}

void look_at(const Pattern::Match& match, std::string_view subject) {
  require(match.begin <= match.end && match.end <= subject.size(), "a match lies within the subject");
  for (const Pattern::Capture& capture : match.captures) {
    require(capture.closed, "a match has no open capture");
    require(capture.start <= subject.size() && capture.length <= subject.size() - capture.start,
            "a capture lies within the subject");
  }
}

void try_pattern(std::string_view text, std::string_view subject) {
  std::int64_t steps = kSteps;
  std::optional<Pattern::Match> match;
  try {
    match = Pattern(text).search(subject, 0, steps);
  } catch (const PatternTooCostly&) {
    require(steps >= -kDearest, "a search ends when its steps are used up");
    return;
  } catch (const PatternError&) {
    return;
  }
  require(steps < kSteps, "a search costs something");
  if (match) look_at(*match, subject);
  // Lua searches a text without special characters literally, with the same result.
  if (text.size() > kLongestForLua || subject.size() > kLongestForLua) return;
  const LuasAnswer answer = ask_lua(subject, text);
  if (answer.malformed) return;  // nested deeper than Lua allows, or found by Lua in a part that is not searched here
  require(answer.match.has_value() == match.has_value(), "both find a match, or neither does");
  if (match)
    require(*answer.match == std::pair(match->begin, match->end), "the match is at the same position as Lua's");
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t separator = input.find('\xFF');
  if (separator != std::string_view::npos) {
    reorient::try_pattern(input.substr(0, separator), input.substr(separator + 1));
  }
  return 0;
}
