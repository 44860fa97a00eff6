// SPDX-License-Identifier: MIT
// The members of a library, read from its text only: functions and values with their doc comments.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/script/script_texts.h"
#include "workbench/script_tools/reference/doc_comment.h"

namespace reorient {

/// A function or another value in the table that a library returns.
struct LibraryMember {
  std::string name;
  bool is_function = false;
  bool is_method = false;               ///< called with a colon
  std::vector<std::string> parameters;  ///< in the order of the function, including "..."
  DocComment doc;
};

struct LibraryModule {
  std::string name;  ///< the argument of `require`: "lib.walk"
  std::string description;
  std::vector<LibraryMember> members;  ///< in the order of the text, without names that begin with "_"
};

/// Finds the members at the outermost level that are written as `function module.name() end`, as `module.name = value`,
/// or in the returned table. A value may be the name of a local function. Never fails: it finds fewer members in
/// invalid Lua.
LibraryModule library_module(std::string name, std::string_view text);

/// The modules of all files below lib/, by name. A file that cannot be used has no members, and the reason as
/// description.
std::vector<LibraryModule> library_modules(const ScriptTexts& texts);

}  // namespace reorient
