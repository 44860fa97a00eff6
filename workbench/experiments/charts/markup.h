// SPDX-License-Identifier: MIT
// HTML and SVG that are well-formed XML, with any names and titles.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace reorient {

/// Escapes text, and attributes in double quotes. Invalid UTF-8 and control characters are escaped, too.
std::string escaped(std::string_view text);

class Markup {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

  void text(std::string_view text) { out_ += escaped(text); }
  /// An element that contains only a text.
  void leaf(std::string_view name, std::string_view text, Attributes attributes = {});
  /// An element without an end tag, such as HTML's <meta> and SVG's <path>.
  void single(std::string_view name, Attributes attributes);
  /// Unchanged, without escapes: for a doctype or a style sheet.
  void raw(std::string_view markup) { out_ += markup; }

  const std::string& str() const { return out_; }

 private:
  friend class Element;
  void begin(std::string_view name, Attributes attributes);

  std::string out_;
};

/// The element is open while this object exists.
class Element {
 public:
  Element(Markup& out, std::string_view name, Markup::Attributes attributes = {});
  ~Element();
  Element(const Element&) = delete;
  Element& operator=(const Element&) = delete;

 private:
  Markup& out_;
  std::string name_;
};

}  // namespace reorient
