// SPDX-License-Identifier: MIT
// What libraries offer, for people and for editors: parts of the script reference and of the annotations.
#pragma once

#include <iosfwd>
#include <span>

#include "workbench/script_tools/reference/library_docs.h"

namespace reorient {

/// Markdown: a heading, a description and a table for each.
void write_libraries(std::ostream& out, std::span<const LibraryModule> modules);

/// For the Lua language server: a class for each, named as `require` names it, and its doc comments as they stand.
void write_library_annotations(std::ostream& out, std::span<const LibraryModule> modules);

/// So that `require "lib.walk"` gives the class of that name.
void write_require_overloads(std::ostream& out, std::span<const LibraryModule> modules);

}  // namespace reorient
