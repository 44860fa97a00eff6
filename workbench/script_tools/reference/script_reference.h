// What scripts can see and say, for people, editors and linters; all made from the declarations that also make the
// bindings. The committed files are docs/script-reference.md, scripts/annotations/reorient.lua and scripts/.luacheckrc.
#pragma once

#include <string>

namespace reorient {

/// Markdown.
std::string script_reference();

/// Definitions for the Lua language server (---@meta).
std::string script_annotations();

/// Configuration of luacheck.
std::string script_luacheck();

}  // namespace reorient
