// SPDX-License-Identifier: MIT
// The isolated Lua state of one script: a budget of instructions, a memory limit, and bounded string functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <lua.hpp>

#include "engine/script/sandbox/metatables.h"
#include "engine/script/sandbox/script_limits.h"
#include "geometry/const_or.h"
#include "geometry/random.h"

namespace reorient {

/// "behaviors/orientation.lua:12:5", without unknown parts: both count from 1, 0 is unknown.
std::string place_text(const std::string& file, int line, int column);

/// An error in a script and its position. `line` and `column` count from 1; 0: unknown.
struct ScriptFault {
  std::string file;
  int line = 0;
  std::string message;    ///< one line, without the position
  std::string traceback;  ///< several lines, may be empty
  int column = 0;         ///< not reported by Lua itself

  /// "behaviors/orientation.lua:12:5: message", without unknown parts.
  std::string text() const;
};

template <typename Visit, ConstOr<ScriptFault> T>
void fields(Visit&& visit, T& fault) {
  visit(fault.file, fault.line, fault.message, fault.traceback, fault.column);
}

class Sandbox {
 public:
  explicit Sandbox(const ScriptLimits& limits);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  lua_State* state() const { return lua_; }
  static Sandbox& of(lua_State* L);

  /// Starts a new budget; the rest of the old one expires.
  void grant(std::int64_t instructions);

  /// Compiles text (never bytecode) and pushes it as a function; on a fault nothing is pushed.
  std::optional<ScriptFault> compile(std::string_view text, const std::string& file);

  /// Calls the function below `arguments` values on the stack within the budget; on a fault the stack is cleared.
  std::optional<ScriptFault> call(int arguments, int results);

  /// Charges the work of C++ functions that a script calls; raises a Lua error if the budget is used up.
  void charge(std::int64_t work);
  /// Charges the iteration of a table with the size of the largest table, because empty slots cannot be counted.
  void charge_walk();
  /// An instruction may compare two texts, read a number in one (as the limit of a `for`), or follow a chain of
  /// metatables: its price grows with the longest text that the script ever made, and with its metatables.
  std::int64_t price_of_instruction() const;
  /// The rest of the budget.
  std::int64_t remaining() const { return remaining_; }
  bool exhausted() const { return exhausted_; }
  /// Raises a Lua error if the budget is used up: call it after each catch of a script's own errors.
  void raise_if_exhausted();
  /// The message handler for each lua_pcall within a script: an error takes far more time than an instruction.
  static int pay_for_error(lua_State* L);

  Metatables& metatables() { return metatables_; }
  /// The random numbers of the script.
  Random& random() { return random_; }

  /// The state besides Lua's own memory: the random numbers, and the cost of its texts.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    std::uint64_t longest_string = self.longest_string_;
    archive(self.random_, longest_string, self.spent_);
    if constexpr (Archive::kReads) self.longest_string_ = longest_string;
  }

  std::size_t string_length() const { return static_cast<std::size_t>(limits_.string_length); }
  std::size_t memory() const { return memory_; }        ///< bytes in use
  std::int64_t instructions() const { return spent_; }  ///< since the start, in steps of a hundred

 private:
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  void find_stack();
  bool is_allowed(const void* block, std::size_t held, std::size_t new_size, bool is_string) const;
  static void count(lua_State* L, lua_Debug* record);
  static int explain(lua_State* L);
  void owe(std::int64_t work);
  ScriptFault take_fault();

  static constexpr std::uint64_t kSeed = 20130624;

  ScriptLimits limits_;
  std::size_t memory_ = 0;
  std::size_t longest_string_ = 0;  ///< bytes, of all strings of the script so far
  std::size_t largest_block_ = 0;   ///< bytes, of all tables of the script so far
  struct Block {
    const void* place = nullptr;
    std::size_t size = 0;
  };
  Block newest_;  ///< the last allocation; empty if it was no new block
  Block stack_;   ///< Lua's
  bool finds_stack_ = false;
  Metatables metatables_;
  std::int64_t granted_ = 0;
  std::int64_t remaining_ = 0;
  std::int64_t spent_ = 0;
  bool exhausted_ = false;
  bool confined_ = false;  ///< whether a script runs, so that limits apply; they must not stop the host's own work
  std::string traceback_;
  Random random_{kSeed};
  lua_State* lua_ = nullptr;
};

/// Splits "behaviors/orientation.lua:12: message" or "...:12:5: message"; without a position, the whole text is the
/// message.
ScriptFault read_fault(std::string_view text, const std::string& file);

}  // namespace reorient
