// SPDX-License-Identifier: MIT
// Checks that a text is well-formed XML, for the subset that the project writes: elements, attributes in double quotes,
// entities.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parameters/utf8.h"

namespace reorient {

/// The error in a text between two elements or in the value of an attribute; empty: no error.
inline std::string mistake_in_text(std::string_view text) {
  constexpr std::array<std::string_view, 5> kEntities{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = static_cast<unsigned char>(text[i]);
    if ((code < ' ' && text[i] != '\n') || code == 0x7F) return "unexpected control character";
    if (text[i] == '<') return "unexpected <";
    bool is_entity = false;
    for (const std::string_view entity : kEntities) is_entity |= text.substr(i).starts_with(entity);
    if (text[i] == '&' && !is_entity) return "unexpected &";
  }
  return "";
}

/// The error in the part of a tag after the element's name: ` a="b" c="d"`.
inline std::string mistake_in_attributes(std::string_view text) {
  constexpr std::string_view kName = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
  while (!text.empty()) {
    const std::size_t equals = text.find("=\"");
    if (text[0] != ' ' || equals == std::string_view::npos || equals < 2) return "invalid attribute";
    if (text.substr(1, equals - 1).find_first_not_of(kName) != std::string_view::npos)
      return "invalid name of an attribute";
    const std::size_t end = text.find('"', equals + 2);
    if (end == std::string_view::npos) return "value without an end";
    if (std::string mistake = mistake_in_text(text.substr(equals + 2, end - equals - 2)); !mistake.empty())
      return mistake;
    text.remove_prefix(end + 1);
  }
  return "";
}

/// One line about the first error; empty: no error.
inline std::string mistake_in_markup(std::string_view page) {
  if (!is_utf8(page)) return "invalid UTF-8";
  constexpr std::string_view kDoctype = "<!DOCTYPE html>\n";
  if (page.starts_with(kDoctype)) page.remove_prefix(kDoctype.size());
  std::vector<std::string_view> open;
  while (!page.empty()) {
    const std::size_t begin = page.find('<');
    if (std::string mistake = mistake_in_text(page.substr(0, begin)); !mistake.empty()) return mistake;
    if (begin == std::string_view::npos) break;
    const std::size_t end = page.find('>', begin);
    if (end == std::string_view::npos) return "tag without an end";
    std::string_view tag = page.substr(begin + 1, end - begin - 1);
    page.remove_prefix(end + 1);
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1))
        return "end tag of an element that is not open: " + std::string(tag);
      open.pop_back();
      continue;
    }
    const bool is_single = tag.ends_with('/');
    if (is_single) tag.remove_suffix(1);
    const std::string_view name = tag.substr(0, tag.find(' '));
    if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789") != std::string_view::npos)
      return "invalid tag: " + std::string(tag);
    if (const std::string mistake = mistake_in_attributes(tag.substr(name.size())); !mistake.empty())
      return mistake + " in " + std::string(tag);
    if (!is_single) open.push_back(name);
  }
  return open.empty() ? "" : "missing end tag of " + std::string(open.back());
}

}  // namespace reorient
