// SPDX-License-Identifier: MIT
// What a command line can name: scenarios, behaviors, experiments, ... with one sentence about each.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace reorient {

struct CatalogEntry {
  std::string name;
  std::string text;  ///< one sentence; may be empty
};

struct CatalogKind {
  const char* name;  ///< "scenarios"
  const char* use;   ///< where a name of this kind is written: "reorient run NAME"
  /// The entries by name. Files that cannot be read have no text.
  std::vector<CatalogEntry> (*entries)(const std::filesystem::path& scripts);
};

/// All kinds, in the order in which they are listed.
std::span<const CatalogKind> catalog();
/// nullptr: unknown.
const CatalogKind* catalog_kind(const std::string& name);

/// The first sentence of a file's leading comment, or the title of an experiment, in one line. Empty: none.
std::string first_sentence(const std::string& text);

}  // namespace reorient
