// SPDX-License-Identifier: MIT
// The results of scripted tests as a JUnit report, which CI systems show.
#pragma once

#include <string>

#include "workbench/script_tools/testing/test_runner.h"

namespace reorient {

std::string junit_report(const TestSummary& summary);

}  // namespace reorient
