// SPDX-License-Identifier: MIT
#include "program/shell/man_page.h"

#include <vector>

#include "program/help.h"

namespace reorient {
namespace {

/// Text of a line that roff reads: no request at its beginning, no escape, and hyphens that can be copied.
std::string as_roff(const std::string& text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out += "\\&";
  for (const char letter : text) {
    if (letter == '\\') {
      out += "\\e";
    } else if (letter == '-') {
      out += "\\-";
    } else {
      out += letter;
    }
  }
  return out;
}

/// An argument of a macro.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char letter : as_roff(text)) out += letter == '"' ? std::string("\\(dq") : std::string(1, letter);
  return out + "\"";
}

std::string literal(const std::string& lines) {
  std::string out = ".PP\n.nf\n";
  std::size_t begin = 0;
  while (begin < lines.size()) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    out += as_roff(lines.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return out + ".fi\n";
}

std::string listed(const std::vector<HelpPage::Entry>& entries) {
  std::string out;
  for (const HelpPage::Entry& entry : entries)
    out += ".TP\n.B " + quoted(entry.name) + "\n" + as_roff(entry.text) + "\n";
  return out;
}

/// All of a page but its name.
std::string body_of(const HelpPage& page) {
  std::string out;
  if (!page.commands.empty()) out += ".PP\nCommands:\n" + listed(page.commands);
  if (!page.arguments.empty()) out += ".PP\nArguments:\n" + listed(page.arguments);
  for (const HelpPage::Group& group : page.groups) out += ".PP\n" + as_roff(group.name) + ":\n" + listed(group.options);
  if (!page.examples.empty()) out += literal(page.examples);
  return out;
}

}  // namespace

std::string man_page(const CLI::App& program) {
  const std::vector<HelpPage> pages = all_pages_of(program);
  const HelpPage& first = pages.front();
  std::string out =
      ".\\\" Generated from the help pages by 'reorient help --man'; do not edit.\n"
      ".TH REORIENT 1 \"\" \"reorient " REORIENT_VERSION
      "\" \"User Commands\"\n"
      ".SH NAME\nreorient \\- orientation and behavior engine for humanoid robots\n.SH SYNOPSIS\n";
  for (const std::string& usage : first.usage) out += ".B " + quoted(usage) + "\n.br\n";
  out += ".SH DESCRIPTION\n" + as_roff(first.purpose) + "\n" + body_of(first) + ".SH COMMANDS\n";
  for (auto page = pages.begin() + 1; page != pages.end(); ++page) {
    out += ".SS " + quoted(page->command) + "\n";
    for (const std::string& usage : page->usage) out += ".B " + quoted(usage) + "\n.br\n";
    out += ".PP\n" + as_roff(page->purpose) + "\n" + body_of(*page);
  }
  return out;
}

}  // namespace reorient
