// SPDX-License-Identifier: MIT
// Lua's string patterns with a cost: every step of a search counts toward the budget, so that each search ends.
// (Lua's own matcher is a C function, which an instruction hook cannot interrupt.)
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace reorient {

/// The pattern is malformed or nests too deeply.
struct PatternError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The granted steps are used up.
struct PatternTooCostly : std::runtime_error {
  PatternTooCostly() : std::runtime_error("pattern takes too many steps") {}
};

/// A pattern as the Lua 5.4 manual describes it, section 6.4.1.
class Pattern {
 public:
  struct Capture {
    std::size_t start = 0;
    std::size_t length = 0;
    bool closed = false;
    bool is_position = false;  ///< "()": the value is start + 1
  };
  struct Match {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::vector<Capture> captures;
  };

  /// Throws PatternError.
  explicit Pattern(std::string_view text);

  /// The first match at `from` or later. `steps` is reduced by the work done; throws PatternTooCostly below zero.
  std::optional<Match> search(std::string_view subject, std::size_t from, std::int64_t& steps) const;

  bool anchored() const { return anchored_; }

 private:
  enum class Kind { one, open, position, close, balance, frontier, reference, subject_end };
  enum class Repeat { once, optional, greedy, greedy_some, lazy };
  struct Item {
    Kind kind = Kind::one;
    Repeat repeat = Repeat::once;
    std::bitset<256> set;  ///< of `one` and `frontier`
    char left = 0;         ///< of `balance`
    char right = 0;
    std::size_t capture = 0;
  };
  class Run;

  Item read_escape(std::string_view text, std::size_t& at);
  Repeat read_repeat(std::string_view text, std::size_t& at);

  std::vector<Item> items_;
  std::size_t captures_ = 0;
  bool anchored_ = false;
};

}  // namespace reorient
