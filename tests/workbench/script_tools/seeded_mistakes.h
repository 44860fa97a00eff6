// SPDX-License-Identifier: MIT
// Typical mistakes in scripts, inserted into a text at random positions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/random.h"

namespace reorient {

enum class Mistake {
  letter_in_a_name,  ///< replaced by another one, or swapped with its neighbor
  letter_in_a_text,  ///< the same in a text that names a state, a parameter, a behavior, a module, a value
  argument_dropped,
  argument_added,
  type_swapped,        ///< a literal of another type: a number in quotes, a number for a text or a truth value
  state_renamed,       ///< where it is declared
  brackets_forgotten,  ///< of a call without arguments
  brackets_added,      ///< to a field
  colon_for_dot,       ///< of a call
  other_table,         ///< a field of the world is read from another of its tables
};
constexpr int enum_count(Mistake) { return 10; }
std::string_view to_string(Mistake mistake);

struct SeededMistake {
  std::string text;  ///< of the whole script
  int line = 0;
  std::string before, after;  ///< the replaced text and its replacement
};

/// `names`: all names that texts may contain. Empty if such a mistake is not possible in the script.
std::optional<SeededMistake> seed_mistake(Mistake mistake, std::string_view script,
                                          const std::vector<std::string>& names, Random& random);

}  // namespace reorient
