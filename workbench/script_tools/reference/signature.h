// SPDX-License-Identifier: MIT
// Arguments and results of a function, read from one line in the notation of the reference.
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
  std::string result;  ///< type, with an optional name after it; several are separated by commas, "..." for any number;
                       ///< may be empty

  std::string full_name() const { return table.empty() ? name : table + "." + name; }
};

/// Throws std::invalid_argument if the text is not a signature.
Signature read_signature(std::string_view text);

/// Splits a type at each separator outside of brackets and quotes, and removes the blanks around the parts:
/// "{ a: string, b: number }, c" has two parts at ','.
std::vector<std::string_view> split_type(std::string_view text, char separator);

/// The definition for the Lua language server: parameters, result, and an empty function.
std::string to_annotation(const Signature& signature);

}  // namespace reorient
