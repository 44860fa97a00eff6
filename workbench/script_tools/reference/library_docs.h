// SPDX-License-Identifier: MIT
// What a library offers to those who require it, from its text alone: functions and values with their doc comments.
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
  std::vector<std::string> parameters;  ///< as the function names them, "..." among them
  DocComment doc;
};

struct LibraryModule {
  std::string name;  ///< as `require` takes it: "lib.walk"
  std::string description;
  std::vector<LibraryMember> members;  ///< in the order of the text; none whose name begins with "_"
};

/// Found are the members that are written at the outermost level, as `function module.name() end`, as
/// `module.name = value`, or in the table that is returned; a value may be the name of a local function. Never fails:
/// in what is no Lua it finds less.
LibraryModule library_module(std::string name, std::string_view text);

/// Of all files below lib/, by name. A file that cannot be used has no members, and a description that says why.
std::vector<LibraryModule> library_modules(const ScriptTexts& texts);

}  // namespace reorient
