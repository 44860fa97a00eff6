// SPDX-License-Identifier: MIT
#include "engine/script/sandbox/sandbox.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <new>
#include <utility>

#include "engine/parameters/utf8.h"
#include "engine/script/sandbox/safe_library.h"

namespace reorient {
namespace {

constexpr int kHookInterval = 100;  // instructions
constexpr std::size_t kStringHeader = 32;
constexpr std::size_t kBytesPerInstruction = 16;
constexpr std::int64_t kRefusalsPerBudget = 2;
constexpr std::int64_t kPriceOfAnError = 2'000;  // unwinding the stack takes about 10 us
constexpr std::size_t kLettersPerInstruction = 128;
constexpr std::size_t kMetatablesPerInstruction = 8;
constexpr std::size_t kBytesWalkedPerInstruction = 256;  // slots of a table, without their content
constexpr std::size_t kLargestStack = 128 * 1024;        // bytes
constexpr int kMostArguments = 250;
constexpr int kDeepestCall = 200;

/// Pushes "file:line: " of the innermost Lua function, if any.
void push_place(lua_State* L) {
  lua_Debug record;
  for (int level = 0; lua_getstack(L, level, &record) != 0; ++level) {
    lua_getinfo(L, "Sl", &record);
    if (record.currentline <= 0) continue;
    lua_pushfstring(L, "%s:%d: ", record.short_src, record.currentline);
    return;
  }
  lua_pushliteral(L, "");
}

}  // namespace

Sandbox::Sandbox(const ScriptLimits& limits) : limits_(limits), lua_(lua_newstate(&Sandbox::allocate, this)) {
  if (lua_ == nullptr) throw std::bad_alloc();
  *static_cast<Sandbox**>(lua_getextraspace(lua_)) = this;
  find_stack();
  open_safe_library(lua_);
}

Sandbox::~Sandbox() { lua_close(lua_); }

Sandbox& Sandbox::of(lua_State* L) { return **static_cast<Sandbox**>(lua_getextraspace(L)); }

void* Sandbox::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  Sandbox& sandbox = *static_cast<Sandbox*>(self);
  const std::size_t held = block == nullptr ? 0 : old_size;  // for a new block Lua passes its kind instead
  const Block newest = std::exchange(sandbox.newest_, {});
  if (new_size == 0) {
    // Lua moves its stack to a new block, then frees the old one.
    if (block != nullptr && (block == sandbox.stack_.place || sandbox.finds_stack_)) sandbox.stack_ = newest;
    std::free(block);
    sandbox.memory_ -= held;
    return nullptr;
  }
  if (sandbox.confined_ && new_size > held) {
    const bool is_string = block == nullptr && old_size == LUA_TSTRING;
    if (!sandbox.is_allowed(block, held, new_size, is_string)) {
      // Lua collects all garbage and retries, which costs far more than an instruction.
      sandbox.remaining_ -= sandbox.granted_ / kRefusalsPerBudget;
      return nullptr;
    }
    sandbox.remaining_ -= static_cast<std::int64_t>((new_size - held) / kBytesPerInstruction);
    std::size_t& largest = is_string ? sandbox.longest_string_ : sandbox.largest_block_;
    largest = std::max(largest, new_size);
  }
  // Before it resizes a table, Lua counts its elements, and requests its block even if the size does not change.
  if (sandbox.confined_) sandbox.remaining_ -= static_cast<std::int64_t>(held / kBytesWalkedPerInstruction);
  void* const result = std::realloc(block, new_size);
  if (result == nullptr) return nullptr;
  sandbox.memory_ += new_size - held;
  if (block == nullptr) sandbox.newest_ = {result, new_size};
  return result;
}

/// The block that Lua frees after requesting a larger stack is the old stack.
void Sandbox::find_stack() {
  finds_stack_ = true;
  lua_checkstack(lua_, 3 * LUA_MINSTACK);
  finds_stack_ = false;
}

/// Whether a script may allocate this size for this purpose.
bool Sandbox::is_allowed(const void* block, std::size_t held, std::size_t new_size, bool is_string) const {
  const std::size_t cap = static_cast<std::size_t>(limits_.max_memory) * 1024;
  const bool too_long = is_string && new_size > string_length() + kStringHeader;
  // Calling a table whose __call is the table itself uses a slot of the stack each time, and moves all arguments.
  // Lua doubles its stack, except for a few slots at its end.
  constexpr std::size_t kEnd = 256;
  const bool is_stack = block == nullptr && new_size <= 2 * stack_.size && new_size + kEnd >= 2 * stack_.size;
  const bool too_deep = is_stack && new_size > kLargestStack;
  return !too_long && !too_deep && new_size <= cap && memory_ - held <= cap - new_size;
}

void Sandbox::count(lua_State* L, lua_Debug* record) {
  Sandbox& sandbox = of(L);
  if (!sandbox.exhausted_) sandbox.spent_ += kHookInterval;
  if (!sandbox.confined_) return;
  sandbox.charge(kHookInterval * sandbox.price_of_instruction());
  lua_Debug outermost;
  if (lua_getstack(L, kDeepestCall, &outermost) != 0) {
    push_place(L);
    lua_pushfstring(L, "calls nested more than %d deep (endless recursion?)", kDeepestCall);
    lua_concat(L, 2);
    lua_error(L);
  }
  // A single instruction copies all of "...".
  if (lua_getlocal(L, record, -kMostArguments - 1) != nullptr) {
    luaL_error(L, "too many arguments (expected at most %d)", kMostArguments);
  }
}

std::int64_t Sandbox::price_of_instruction() const {
  return static_cast<std::int64_t>(1 + longest_string_ / kLettersPerInstruction +
                                   metatables_.held() / kMetatablesPerInstruction);
}

void Sandbox::charge_walk() { charge(static_cast<std::int64_t>(largest_block_ / kBytesWalkedPerInstruction)); }

void Sandbox::grant(std::int64_t instructions) {
  granted_ = instructions;
  remaining_ = instructions;
  exhausted_ = false;
  lua_sethook(lua_, &Sandbox::count, LUA_MASKCOUNT, kHookInterval);
}

void Sandbox::charge(std::int64_t work) {
  owe(work);
  raise_if_exhausted();
}

/// After the end of the budget no instruction runs: an error first closes the variables that are to be
/// closed, and functions that open new ones meanwhile would run forever.
void Sandbox::owe(std::int64_t work) {
  remaining_ = work > remaining_ ? -1 : remaining_ - work;
  if (remaining_ >= 0 || exhausted_) return;
  exhausted_ = true;
  lua_sethook(lua_, &Sandbox::count, LUA_MASKCOUNT, 1);
}

void Sandbox::raise_if_exhausted() {
  owe(0);  // charges what allocate() could not report
  if (!exhausted_) return;
  push_place(lua_);
  lua_pushfstring(lua_, "budget of %I instructions used up: endless loop or too much work",
                  static_cast<LUAI_UACINT>(granted_));
  lua_concat(lua_, 2);
  lua_error(lua_);
}

int Sandbox::pay_for_error(lua_State* L) {
  of(L).owe(kPriceOfAnError);
  return 1;
}

int Sandbox::explain(lua_State* L) {
  Sandbox& sandbox = of(L);
  sandbox.owe(kPriceOfAnError);
  const bool confined = sandbox.confined_;
  sandbox.confined_ = false;
  if (!lua_isstring(L, 1)) {
    lua_pushfstring(L, "error value of type %s (expected a string)", luaL_typename(L, 1));
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
  std::replace(fault.message.begin(), fault.message.end(), '\n', ' ');
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
  if (status == LUA_ERRMEM) fault.message = "memory limit exceeded, or string too long";
  return fault;
}

std::optional<ScriptFault> Sandbox::compile(std::string_view text, const std::string& file) {
  text = without_byte_order_mark(text);  // Lua refuses it
  const bool confined = std::exchange(confined_, true);
  const std::size_t largest_block = largest_block_;
  const int status = luaL_loadbufferx(lua_, text.data(), text.size(), ("@" + file).c_str(), "t");
  largest_block_ = largest_block;  // the compiler's lists are not tables of the script
  confined_ = confined;
  if (status == LUA_OK) return std::nullopt;
  ScriptFault fault = take_fault();
  if (status == LUA_ERRMEM) fault.message = "script exceeds the memory limit, or contains a string that is too long";
  if (fault.file.empty()) fault.file = file;
  return fault;
}

std::string place_text(const std::string& file, int line, int column) {
  std::string place = file;
  if (line > 0) place += ":" + std::to_string(line);
  if (line > 0 && column > 0) place += ":" + std::to_string(column);
  return place;
}

std::string ScriptFault::text() const { return place_text(file, line, column) + ": " + message; }

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
