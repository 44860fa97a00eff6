// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/library_reference.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace reorient {
namespace {

/// "walk_to(x, y, rotation?)" for a function, the name for another value.
std::string signature(const LibraryMember& member) {
  if (!member.is_function) return member.name;
  std::string list;
  for (const std::string& name : member.parameters) {
    const DocTag* const tag = member.doc.parameter(name);
    list.append(list.empty() ? "" : ", ").append(name).append(tag != nullptr && tag->is_optional ? "?" : "");
  }
  return (member.is_method ? ":" : "") + member.name + "(" + list + ")";
}

/// Escapes bars, which would end a cell of a table.
std::string cell(const std::string& text) {
  std::string out;
  for (const char letter : text) out.append(letter == '|' ? "\\" : "").append(1, letter);
  return out;
}

std::string code(std::string text) {
  std::replace(text.begin(), text.end(), '`', '\'');
  return text.empty() ? "" : "`" + cell(text) + "`";
}

/// "`x: number` m, towards the opponent goal". Any part may be missing.
std::string tag_text(const DocTag& tag) {
  std::string what = tag.name;
  if (!tag.type.empty()) what += (what.empty() ? "" : ": ") + tag.type;
  std::string text = code(what);
  if (!tag.description.empty()) text += (text.empty() ? "" : " ") + cell(tag.description);
  return text;
}

std::string list_of(const std::vector<DocTag>& tags) {
  std::string text;
  for (const DocTag& tag : tags) text += (text.empty() ? "" : "; ") + tag_text(tag);
  return text;
}

}  // namespace

void write_libraries(std::ostream& out, std::span<const LibraryModule> modules) {
  for (const LibraryModule& module : modules) {
    out << "### `" << module.name << "`\n";
    if (!module.description.empty()) out << module.description << "\n";
    out << "\n";
    if (module.members.empty()) continue;
    out << "| name | arguments | result | what it is |\n|---|---|---|---|\n";
    for (const LibraryMember& member : module.members) {
      out << "| " << code(signature(member)) << " | " << list_of(member.doc.parameters) << " | "
          << (member.is_function ? list_of(member.doc.results) : code(member.doc.type)) << " | "
          << cell(member.doc.description) << " |\n";
    }
    out << "\n";
  }
}

void write_library_annotations(std::ostream& out, std::span<const LibraryModule> modules) {
  for (const LibraryModule& module : modules) {
    out << "do\n";
    if (!module.description.empty()) out << "---" << module.description << "\n";
    out << "---@class " << module.name << "\nlocal library = {}\n";
    for (const LibraryMember& member : module.members) {
      out << "\n";
      for (const std::string& line : member.doc.lines) out << line << "\n";
      if (!member.is_function) {
        out << "library." << member.name << " = nil\n";
        continue;
      }
      std::string list;
      for (const std::string& name : member.parameters) list.append(list.empty() ? "" : ", ").append(name);
      out << "function library" << (member.is_method ? ":" : ".") << member.name << "(" << list << ") end\n";
    }
    out << "end\n\n";
  }
}

void write_require_overloads(std::ostream& out, std::span<const LibraryModule> modules) {
  for (const LibraryModule& module : modules)
    out << "---@overload fun(module: \"" << module.name << "\"): " << module.name << "\n";
}

}  // namespace reorient
