// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/junit_report.h"

#include <string_view>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

/// XML 1.0 does not allow these two Unicode code points.
bool is_noncharacter(std::string_view letter) { return letter == "\xEF\xBF\xBE" || letter == "\xEF\xBF\xBF"; }

/// Text for the content of an element or for an attribute in quotes. XML 1.0 does not allow most control characters,
/// not even escaped.
std::string as_xml(const std::string& text) {
  const std::string utf8 = as_utf8(text);
  std::string out;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const char letter = utf8[i];
    if (letter == '<') {
      out += "&lt;";
    } else if (letter == '>') {
      out += "&gt;";
    } else if (letter == '&') {
      out += "&amp;";
    } else if (letter == '"') {
      out += "&quot;";
    } else if (static_cast<unsigned char>(letter) < ' ' && letter != '\n' && letter != '\t') {
      out += written_out({&letter, 1});
    } else if (const std::string_view three = std::string_view(utf8).substr(i, 3); is_noncharacter(three)) {
      out += written_out(three);
      i += 2;
    } else {
      out += letter;
    }
  }
  return out;
}

}  // namespace

std::string junit_report(const TestSummary& summary) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"reorient test\" tests=\"" +
                    std::to_string(summary.cases.size()) + "\" failures=\"" + std::to_string(summary.failed) +
                    "\" skipped=\"" + std::to_string(summary.skipped) + "\">\n";
  for (const TestCase& test : summary.cases) {
    out += "  <testcase classname=\"" + as_xml(test.file) + "\" name=\"" + as_xml(test.name) + "\">\n";
    if (test.skipped) out += "    <skipped/>\n";
    for (const TestFailure& failure : test.failures) {
      out += "    <failure message=\"" + as_xml(failure.file) + ":" + std::to_string(failure.line) + "\">" +
             as_xml(failure.text) + "</failure>\n";
    }
    out += "  </testcase>\n";
  }
  return out + "</testsuite>\n";
}

}  // namespace reorient
