// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/doc_comment.h"

#include <algorithm>
#include <cctype>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool is_rule(std::string_view line) { return line.find_first_not_of('-') == std::string_view::npos; }

/// Makes the text printable, because a script may contain any bytes but the generated pages may not.
std::string printable(std::string_view line) {
  std::string out;
  for (const char letter : as_utf8(line)) {
    const bool is_control = (static_cast<unsigned char>(letter) < ' ' && letter != '\t') || letter == '\x7F';
    out += is_control ? written_out({&letter, 1}) : std::string(1, letter);
  }
  return out;
}

/// Removes and returns the first word of the text, with the blanks after it.
std::string take(std::string_view& text, std::size_t size) {
  std::string taken(text.substr(0, size));
  text = trimmed(text.substr(std::min(size, text.size())));
  return taken;
}

std::string take_word(std::string_view& text) { return take(text, text.find_first_of(kBlanks)); }

/// The type at the beginning of the text. Blanks in brackets, in quotes and next to | : , belong to it.
std::string take_type(std::string_view& text) {
  int open = 0;
  char quote = '\0';
  char before = '\0';  // the last character that is not a blank
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    const char c = text[end];
    const bool is_blank = kBlanks.find(c) != std::string_view::npos;
    const bool is_in_word = std::isalnum(static_cast<unsigned char>(before)) != 0;
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if ((c == '"' || c == '\'') && !is_in_word) {
      quote = c;
    } else if (std::string_view("([{<").find(c) != std::string_view::npos) {
      ++open;
    } else if (std::string_view(")]}>").find(c) != std::string_view::npos) {
      --open;
    } else if (is_blank && open <= 0 && std::string_view("|:,").find(before) == std::string_view::npos &&
               !trimmed(text.substr(end)).starts_with('|')) {
      break;
    }
    if (!is_blank) before = c;
  }
  return take(text, end);
}

/// The rest of a tag, without the mark # or @ that may precede it.
std::string take_description(std::string_view& text) {
  if (text.starts_with('#') || text.starts_with('@')) text = trimmed(text.substr(1));
  return std::string(text);
}

bool may_be_nil(std::string_view type) {
  return type.ends_with('?') || type.ends_with("|nil") || type.ends_with("| nil");
}

DocTag parameter_tag(std::string_view text) {
  DocTag tag;
  tag.name = take_word(text);
  tag.type = take_type(text);
  tag.description = take_description(text);
  tag.is_optional = tag.name.ends_with('?') || may_be_nil(tag.type);
  if (tag.name.ends_with('?')) tag.name.pop_back();
  return tag;
}

DocTag result_tag(std::string_view text) {
  DocTag tag;
  tag.type = take_type(text);
  if (!text.starts_with('#')) tag.name = take_word(text);
  tag.description = take_description(text);
  tag.is_optional = may_be_nil(tag.type);
  return tag;
}

}  // namespace

const DocTag* DocComment::parameter(std::string_view name) const {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [name](const DocTag& tag) { return tag.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

bool is_doc_line(std::string_view line) {
  line = trimmed(line);
  return line.starts_with("---") && (!line.starts_with("----") || is_rule(line));
}

DocComment doc_comment(const std::vector<std::string_view>& lines) {
  DocComment doc;
  for (const std::string_view line : lines) {
    if (is_rule(trimmed(line))) continue;
    doc.lines.push_back(printable(trimmed(line)));
    std::string_view text = trimmed(std::string_view(doc.lines.back()).substr(3));
    if (!text.starts_with('@')) {
      if (!text.starts_with('|')) doc.description.append(doc.description.empty() ? "" : " ").append(text);
      continue;
    }
    const std::string tag = take_word(text);
    if (tag == "@param") doc.parameters.push_back(parameter_tag(text));
    if (tag == "@return") doc.results.push_back(result_tag(text));
    if (tag == "@type") doc.type = take_type(text);
  }
  return doc;
}

}  // namespace reorient
