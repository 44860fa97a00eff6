// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/junit_report.h"

#include <iomanip>
#include <sstream>
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

/// One element for all failures of the test.
std::string result_of(const TestCase& test) {
  if (test.skipped) return "    <skipped/>\n";
  if (test.failures.empty()) return {};
  std::string text;
  for (const TestFailure& failure : test.failures) {
    if (!text.empty()) text += "\n" + as_xml(place_text(failure.file, failure.line, 0)) + ":\n";
    text += as_xml(failure.text);
  }
  const TestFailure& first = test.failures.front();
  const std::string element = test.has_run ? "failure" : "error";
  return "    <" + element + " message=\"" + as_xml(place_text(first.file, first.line, 0)) + "\" type=\"" +
         (test.has_run ? "expectation" : "not run") + "\">" + text + "</" + element + ">\n";
}

}  // namespace

std::string junit_report(const TestSummary& summary, const JunitOrigin& origin) {
  std::ostringstream cases;
  std::string printed;
  cases << std::fixed << std::setprecision(3);
  double seconds = 0.0;
  int errors = 0;
  for (const TestCase& test : summary.cases) {
    seconds += test.seconds;
    if (!test.has_run) ++errors;
    for (const std::string& line : test.printed)
      printed += as_xml(as_line(test.file + ": " + test.name + ": " + line)) + "\n";
    cases << "  <testcase classname=\"" << as_xml(test.file) << "\" name=\"" << as_xml(test.name) << "\" time=\""
          << test.seconds << "\">\n"
          << result_of(test) << "  </testcase>\n";
  }
  std::ostringstream out;
  out << std::fixed << std::setprecision(3) << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << "<testsuite name=\"reorient test\" timestamp=\"" << as_xml(origin.timestamp) << "\" hostname=\""
      << as_xml(origin.hostname) << "\" tests=\"" << summary.cases.size() << "\" failures=\"" << summary.failed - errors
      << "\" errors=\"" << errors << "\" skipped=\"" << summary.skipped << "\" time=\"" << seconds
      << "\">\n  <properties/>\n"
      << cases.str() << (printed.empty() ? "  <system-out/>\n" : "  <system-out>" + printed + "</system-out>\n")
      << "  <system-err/>\n</testsuite>\n";
  return out.str();
}

}  // namespace reorient
