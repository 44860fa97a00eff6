// SPDX-License-Identifier: MIT
// Comments in the form of the Lua language server: lines that begin with `---`, tags with `@`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// `---@param name type description` or `---@return type name description`, of which the last ones may be missing.
struct DocTag {
  std::string name;
  std::string type;
  std::string description;
  bool is_optional = false;  ///< `name?`, `type?` or `type|nil`
};

struct DocComment {
  std::vector<std::string> lines;  ///< as they were written, without what stands around; printable UTF-8
  std::string description;         ///< all that is no tag, in one line
  std::vector<DocTag> parameters;
  std::vector<DocTag> results;
  std::string type;  ///< `---@type`

  /// nullptr: not found.
  const DocTag* parameter(std::string_view name) const;
};

/// Whether the line is part of such a comment: three dashes and no fourth one, or a rule of dashes alone.
bool is_doc_line(std::string_view line);

/// From lines of that kind. Never fails: a tag that cannot be read has less in it.
DocComment doc_comment(const std::vector<std::string_view>& lines);

}  // namespace reorient
