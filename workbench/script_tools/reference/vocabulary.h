// SPDX-License-Identifier: MIT
// The words of scripts and of their tests that are more than a plain function, and Lua's library, as documentation: the
// reference, the annotations and the check are made from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

struct ScriptWord {
  std::string_view signature;  ///< signature.h; of what is no function its name alone
  std::string_view usage;      ///< an example
  std::string_view description;
  std::string_view annotation;  ///< for the Lua language server, where it is more than the signature

  std::string_view name() const { return signature.substr(0, signature.find('(')); }  ///< "param", "expect.state"
  bool is_function() const { return signature.find('(') != std::string_view::npos; }
};

/// Of every script; `scenario` and `behavior` among them.
std::span<const ScriptWord> language_words();

/// Of the files *_test.lua.
std::span<const ScriptWord> test_words();

/// What scripts have of Lua's own library, by table; the first row is that of the globals.
struct LibraryRow {
  std::string_view table;
  std::span<const std::string_view> signatures;  ///< "math.abs(x: number): number", "math.pi: number"
};
std::span<const LibraryRow> library_rows();

/// A type in signatures whose values are texts.
struct NameType {
  std::string_view type;           ///< "reorient.Verdict"
  std::vector<std::string> names;  ///< all that it can be; empty: what the scripts themselves declare
};
std::vector<NameType> name_types();

/// "set_world" takes tables of world fields: this type's name in signatures.
inline constexpr std::string_view kWorldType = "reorient.World";

}  // namespace reorient
