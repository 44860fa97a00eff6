// SPDX-License-Identifier: MIT
// Comments in the form of the Lua language server: lines that begin with `---`, tags with `@`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// `---@param name type description` or `---@return type name description`. The last parts may be missing.
struct DocTag {
  std::string name;
  std::string type;
  std::string description;
  bool is_optional = false;  ///< `name?`, `type?` or `type|nil`
};

struct DocComment {
  std::vector<std::string> lines;  ///< the lines without their indentation, as printable UTF-8
  std::string description;         ///< all text outside of tags, in one line
  std::vector<DocTag> parameters;
  std::vector<DocTag> results;
  std::string type;  ///< `---@type`

  /// Returns nullptr if there is no such parameter.
  const DocTag* parameter(std::string_view name) const;
};

/// Whether the line is part of such a comment: it begins with exactly three dashes, or consists of dashes only.
bool is_doc_line(std::string_view line);

/// Reads such lines. Never fails: parts of a tag that cannot be read stay empty.
DocComment doc_comment(const std::vector<std::string_view>& lines);

}  // namespace reorient
