// SPDX-License-Identifier: MIT
#include "workbench/experiments/charts/markup.h"

#include "engine/parameters/utf8.h"

namespace reorient {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : as_utf8(text)) {
    const auto code = static_cast<unsigned char>(letter);
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\n':
      case '\t':
        out += ' ';
        break;
      default:
        out += code < ' ' || code == 0x7F ? written_out({&letter, 1}) : std::string(1, letter);
    }
  }
  return out;
}

void Markup::begin(std::string_view name, Attributes attributes) {
  out_.append("<").append(name);
  for (const auto& [attribute, value] : attributes)
    out_.append(" ").append(attribute).append("=\"").append(escaped(value)).append("\"");
}

void Markup::leaf(std::string_view name, std::string_view text, Attributes attributes) {
  const Element element(*this, name, attributes);
  this->text(text);
}

void Markup::single(std::string_view name, Attributes attributes) {
  begin(name, attributes);
  out_ += "/>";
}

Element::Element(Markup& out, std::string_view name, Markup::Attributes attributes) : out_(out), name_(name) {
  out_.begin(name, attributes);
  out_.out_ += ">";
}

Element::~Element() {
  // A line break counts as a blank within text.
  const bool is_within_text = name_ == "a" || name_ == "code" || name_ == "strong" || name_ == "span";
  out_.out_.append("</").append(name_).append(is_within_text ? ">" : ">\n");
}

}  // namespace reorient
