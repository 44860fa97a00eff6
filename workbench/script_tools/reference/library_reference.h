// SPDX-License-Identifier: MIT
// The members of libraries, for readers and for editors: parts of the script reference and of the annotations.
#pragma once

#include <iosfwd>
#include <span>

#include "workbench/script_tools/reference/library_docs.h"

namespace reorient {

/// Markdown: a heading, a description and a table for each.
void write_libraries(std::ostream& out, std::span<const LibraryModule> modules);

/// For the Lua language server: a class for each, with the name that `require` uses and with its doc comments
/// unchanged.
void write_library_annotations(std::ostream& out, std::span<const LibraryModule> modules);

/// Overloads with which `require "lib.walk"` returns the class of that name.
void write_require_overloads(std::ostream& out, std::span<const LibraryModule> modules);

}  // namespace reorient
