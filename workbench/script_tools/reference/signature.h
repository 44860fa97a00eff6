// SPDX-License-Identifier: MIT
// What a function takes and gives, read from one line as the reference shows it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/script/language/script_language.h"

namespace reorient {

/// "expect.command(name: reorient.CommandName, verdict?: reorient.Verdict)", "math.max(x: number, ...: number):
/// number". Types are those of the Lua language server.
struct Signature {
  std::string table;  ///< "expect"; empty: a global function
  std::string name;
  std::vector<ArgumentDoc> arguments;  ///< the last one may be called "..."
  std::string result;  ///< type, and perhaps a name behind it; several with commas, "..." for any number; or empty

  std::string full_name() const { return table.empty() ? name : table + "." + name; }
};

/// Throws std::invalid_argument where the text is no signature.
Signature read_signature(std::string_view text);

/// Its parts at the separator that stands in no bracket and no quotes, without the blanks around them: of
/// "{ a: string, b: number }, c" at ',' two.
std::vector<std::string_view> split_type(std::string_view text, char separator);

/// The definition for the Lua language server: parameters, result, and an empty function.
std::string to_annotation(const Signature& signature);

}  // namespace reorient
