// The words of scripts and of their tests that are more than a plain function, as documentation.
#pragma once

#include <span>
#include <string_view>

namespace reorient {

struct ScriptWord {
  std::string_view name;   ///< "param", "expect.state"
  std::string_view usage;  ///< an example
  std::string_view description;
  std::string_view annotation;  ///< parameters and result, as the Lua language server reads them
};

/// Of every script; `scenario` and `behavior` among them.
std::span<const ScriptWord> language_words();

/// Of the files *_test.lua.
std::span<const ScriptWord> test_words();

/// What scripts have of Lua's own library, by table; the first row is that of the globals.
struct LibraryRow {
  std::string_view table;
  std::string_view names;  ///< separated by blanks
};
std::span<const LibraryRow> library_rows();

}  // namespace reorient
