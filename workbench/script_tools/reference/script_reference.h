// SPDX-License-Identifier: MIT
// The names that scripts can use, for readers, editors and linters: generated from the declarations of the bindings and
// from the doc comments of libraries. The committed files are docs/script-reference.md,
// scripts/annotations/reorient.lua and scripts/.luacheckrc.
#pragma once

#include <span>
#include <string>

#include "workbench/script_tools/reference/library_docs.h"

namespace reorient {

/// Markdown.
std::string script_reference(std::span<const LibraryModule> libraries);

/// Definitions for the Lua language server (---@meta).
std::string script_annotations(std::span<const LibraryModule> libraries);

/// Configuration of luacheck.
std::string script_luacheck();

}  // namespace reorient
