#include "engine/script/sandbox/sandbox.h"

#include <charconv>
#include <cstdlib>
#include <new>
#include <utility>

#include "engine/script/sandbox/safe_library.h"

namespace reorient {
namespace {

constexpr int kHookInterval = 100;  // instructions
constexpr std::size_t kStringHeader = 32;
constexpr std::size_t kBytesPerInstruction = 16;
constexpr std::int64_t kRefusalsPerBudget = 2;
constexpr int kDeepestCall = 200;

}  // namespace

Sandbox::Sandbox(const ScriptLimits& limits) : limits_(limits), lua_(lua_newstate(&Sandbox::allocate, this)) {
  if (lua_ == nullptr) throw std::bad_alloc();
  *static_cast<Sandbox**>(lua_getextraspace(lua_)) = this;
  open_safe_library(lua_);
}

Sandbox::~Sandbox() { lua_close(lua_); }

Sandbox& Sandbox::of(lua_State* L) { return **static_cast<Sandbox**>(lua_getextraspace(L)); }

void* Sandbox::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  Sandbox& sandbox = *static_cast<Sandbox*>(self);
  const std::size_t held = block == nullptr ? 0 : old_size;  // for a new block Lua passes its kind instead
  if (new_size == 0) {
    std::free(block);
    sandbox.memory_ -= held;
    return nullptr;
  }
  if (sandbox.confined_ && new_size > held) {
    const std::size_t cap = static_cast<std::size_t>(sandbox.limits_.memory) * 1024;
    const bool is_string = block == nullptr && old_size == LUA_TSTRING;
    const bool too_long = is_string && new_size > sandbox.string_length() + kStringHeader;
    if (too_long || new_size > cap || sandbox.memory_ - held > cap - new_size) {
      // Lua now collects all garbage and tries again, which costs far more than an instruction.
      sandbox.remaining_ -= sandbox.granted_ / kRefusalsPerBudget;
      return nullptr;
    }
    sandbox.remaining_ -= static_cast<std::int64_t>((new_size - held) / kBytesPerInstruction);
  }
  void* const result = std::realloc(block, new_size);
  if (result != nullptr) sandbox.memory_ += new_size - held;
  return result;
}

void Sandbox::count(lua_State* L, lua_Debug*) {
  Sandbox& sandbox = of(L);
  sandbox.spent_ += kHookInterval;
  if (!sandbox.confined_) return;
  sandbox.charge(kHookInterval);
  lua_Debug outermost;
  if (lua_getstack(L, kDeepestCall, &outermost) != 0) {
    luaL_error(L, "functions call each other more than %d deep: a recursion that does not end", kDeepestCall);
  }
}

void Sandbox::grant(std::int64_t instructions) {
  granted_ = instructions;
  remaining_ = instructions;
  exhausted_ = false;
  lua_sethook(lua_, &Sandbox::count, LUA_MASKCOUNT, kHookInterval);
}

void Sandbox::charge(std::int64_t work) {
  remaining_ = work > remaining_ ? -1 : remaining_ - work;
  if (remaining_ < 0) exhausted_ = true;
  raise_if_exhausted();
}

void Sandbox::raise_if_exhausted() {
  if (!exhausted_) return;
  const auto granted = static_cast<lua_Integer>(granted_);
  luaL_error(lua_, "the budget of %I instructions is used up: a loop that does not end, or too much work", granted);
}

int Sandbox::explain(lua_State* L) {
  Sandbox& sandbox = of(L);
  const bool confined = sandbox.confined_;
  sandbox.confined_ = false;
  if (!lua_isstring(L, 1)) {
    lua_pushfstring(L, "the error is a %s value, not a text", luaL_typename(L, 1));
    lua_replace(L, 1);
  }
  luaL_traceback(L, L, nullptr, 1);
  sandbox.traceback_ = lua_tostring(L, -1);
  lua_pop(L, 1);
  sandbox.confined_ = confined;
  return 1;
}

ScriptFault Sandbox::take_fault() {
  ScriptFault fault = read_fault(lua_isstring(lua_, -1) ? lua_tostring(lua_, -1) : "unknown error", "");
  fault.traceback.swap(traceback_);
  lua_pop(lua_, 1);
  return fault;
}

std::optional<ScriptFault> Sandbox::call(int arguments, int results) {
  traceback_.clear();
  const bool confined = std::exchange(confined_, true);
  const int handler = lua_gettop(lua_) - arguments;
  lua_pushcfunction(lua_, &Sandbox::explain);
  lua_insert(lua_, handler);
  const int status = lua_pcall(lua_, arguments, results, handler);
  lua_remove(lua_, handler);
  confined_ = confined;
  if (status == LUA_OK) return std::nullopt;
  ScriptFault fault = take_fault();
  if (status == LUA_ERRMEM) fault.message = "more memory than a script may hold, or a string that is too long";
  return fault;
}

std::optional<ScriptFault> Sandbox::compile(std::string_view text, const std::string& file) {
  const bool confined = std::exchange(confined_, true);
  const int status = luaL_loadbufferx(lua_, text.data(), text.size(), ("@" + file).c_str(), "t");
  confined_ = confined;
  if (status == LUA_OK) return std::nullopt;
  ScriptFault fault = take_fault();
  if (status == LUA_ERRMEM) fault.message = "the script needs more memory than it may hold, or has too long a string";
  if (fault.file.empty()) fault.file = file;
  return fault;
}

std::string ScriptFault::text() const {
  std::string place = file;
  if (line > 0) place += ":" + std::to_string(line);
  if (line > 0 && column > 0) place += ":" + std::to_string(column);
  return place + ": " + message;
}

ScriptFault read_fault(std::string_view text, const std::string& file) {
  ScriptFault fault{file, 0, std::string(text), {}};
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':', colon + 1)) {
    const char* const begin = text.data() + colon + 1;
    const char* const end = text.data() + text.size();
    int line = 0;
    const auto [rest, error] = std::from_chars(begin, end, line);
    if (error != std::errc() || rest == end || *rest != ':') continue;
    const char* message = rest + 1;
    int column = 0;
    const auto [after, no_column] = std::from_chars(message, end, column);
    if (no_column == std::errc() && after != end && *after == ':') {
      fault.column = column;
      message = after + 1;
    }
    fault.file = std::string(text.substr(0, colon));
    fault.line = line;
    fault.message = std::string(message, end);
    if (fault.message.starts_with(' ')) fault.message.erase(0, 1);
    break;
  }
  return fault;
}

}  // namespace reorient
