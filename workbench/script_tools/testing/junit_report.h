// SPDX-License-Identifier: MIT
// The results of scripted tests as a JUnit report, which CI systems show. It is valid in the common schemas of Ant and
// Jenkins, which require each attribute and allow one failure in a test.
#pragma once

#include <string>

#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {

/// Where and when the tests ran.
struct JunitOrigin {
  std::string hostname;
  std::string timestamp;  ///< start, UTC, such as "2026-11-29T15:30:00"
};

/// A test that was never begun, because its file cannot run or has no time left, counts as an error, not a failure.
std::string junit_report(const TestSummary& summary, const JunitOrigin& origin);

}  // namespace reorient
