// SPDX-License-Identifier: MIT
// Documentation of the words of scripts and of their tests, and of Lua's library. The reference, the annotations and
// the check are generated from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

struct ScriptWord {
  std::string_view signature;  ///< see signature.h; only the name if it is not a function
  std::string_view usage;      ///< an example
  std::string_view description;
  std::string_view annotation;  ///< for the Lua language server, if the signature is not enough

  std::string_view name() const { return signature.substr(0, signature.find('(')); }  ///< "param", "expect.state"
  bool is_function() const { return signature.find('(') != std::string_view::npos; }
};

/// Words of every script, including `scenario` and `behavior`.
std::span<const ScriptWord> language_words();

/// Words of the files *_test.lua.
std::span<const ScriptWord> test_words();

/// The part of Lua's own library that scripts may use, by table. The first row contains the globals.
struct LibraryRow {
  std::string_view table;
  std::span<const std::string_view> signatures;  ///< "math.abs(x: number): number", "math.pi: number"
};
std::span<const LibraryRow> library_rows();

/// A type in signatures whose values are texts.
struct NameType {
  std::string_view type;           ///< "reorient.Verdict"
  std::vector<std::string> names;  ///< all possible values; empty: names that the scripts declare
};
std::vector<NameType> name_types();

/// Name of the type in signatures for the tables of world fields that `set_world` takes.
inline constexpr std::string_view kWorldType = "reorient.World";

}  // namespace reorient
