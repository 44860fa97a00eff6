#include "workbench/script_tools/testing/junit_report.h"

namespace reorient {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(letter) < ' ' && letter != '\n' ? ' ' : letter;
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
    out += "  <testcase classname=\"" + escaped(test.file) + "\" name=\"" + escaped(test.name) + "\">\n";
    if (test.skipped) out += "    <skipped/>\n";
    for (const TestFailure& failure : test.failures) {
      out += "    <failure message=\"" + escaped(failure.file) + ":" + std::to_string(failure.line) + "\">" +
             escaped(failure.text) + "</failure>\n";
    }
    out += "  </testcase>\n";
  }
  return out + "</testsuite>\n";
}

}  // namespace reorient
