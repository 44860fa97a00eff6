// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/value_differences.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parameters/utf8.h"
#include "engine/script/sandbox/safe_library.h"
#include "engine/script/sandbox/sandbox.h"

namespace reorient {
namespace {

constexpr int kDeepest = 20;
constexpr std::size_t kMostLines = 10;

/// On one line, as in a script: different texts stay different.
std::string quoted_text(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) out += letter == '\n' ? "\\n" : letter == '\t' ? "\\t" : std::string(1, letter);
  return as_line(out + "\"");
}

std::string text_of(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TSTRING) return quoted_text({lua_tostring(L, index), lua_rawlen(L, index)});
  push_text(L, index);
  std::string text = lua_tostring(L, -1);
  lua_pop(L, 1);
  return text;
}

/// "[1]" or ".name".
std::string step(lua_State* L, int key) {
  if (lua_type(L, key) == LUA_TSTRING) return "." + as_line(lua_tostring(L, key));
  return "[" + text_of(L, key) + "]";
}

class ValueComparison {
 public:
  explicit ValueComparison(lua_State* L) : lua_(L) {}

  void compare(int actual, int expected, const std::string& path) {
    pay(path);
    if (lua_rawequal(lua_, actual, expected) != 0 || lines_.size() >= kMostLines) return;
    if (!lua_istable(lua_, actual) || !lua_istable(lua_, expected) || depth_ >= kDeepest) {
      // 1 and 1.0 are raw-equal, and equal texts are, too. So the values differ here.
      return note(path, text_of(lua_, expected), text_of(lua_, actual));
    }
    ++depth_;
    luaL_checkstack(lua_, 8, "the tables are nested too deeply");
    for (lua_pushnil(lua_); lua_next(lua_, expected) != 0; lua_pop(lua_, 1)) {
      const int value = lua_gettop(lua_);
      lua_pushvalue(lua_, value - 1);
      lua_rawget(lua_, actual);
      compare(value + 1, value, path + step(lua_, value - 1));
      lua_pop(lua_, 1);
    }
    for (lua_pushnil(lua_); lua_next(lua_, actual) != 0; lua_pop(lua_, 1)) {
      pay(path);
      const int value = lua_gettop(lua_);
      lua_pushvalue(lua_, value - 1);
      if (lua_rawget(lua_, expected) == LUA_TNIL) note(path + step(lua_, value - 1), "nothing", text_of(lua_, value));
      lua_pop(lua_, 1);
    }
    --depth_;
  }

  std::string text() const {
    std::string all;
    for (const std::string& line : lines_) all += (all.empty() ? "" : "\n") + line;
    return all;
  }

 private:
  /// Charges the script, because tables that contain each other many times have too many fields to compare.
  void pay(const std::string& path) {
    constexpr std::int64_t kPriceOfAField = 10;
    Sandbox::of(lua_).charge(kPriceOfAField + static_cast<std::int64_t>(path.size()));
  }

  void note(const std::string& path, const std::string& expected, const std::string& actual) {
    if (lines_.size() >= kMostLines) return;
    lines_.push_back(path.empty() ? "expected " + expected + "\n  actual " + actual
                                  : "at " + path + ": expected " + expected + ", actual " + actual);
  }

  lua_State* lua_;
  int depth_ = 0;
  std::vector<std::string> lines_;
};

}  // namespace

std::string value_differences(lua_State* L, int actual, int expected) {
  ValueComparison comparison(L);
  comparison.compare(lua_absindex(L, actual), lua_absindex(L, expected), "");
  return comparison.text();
}

}  // namespace reorient
