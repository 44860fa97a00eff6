// The scripted tests of the shipped behaviours, and what the shipped files must look like.
#include <sstream>

#include <gtest/gtest.h>

#include "engine/script/test_runner.h"

namespace reorient {
namespace {

const std::filesystem::path kScripts = std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts";

TEST(ShippedScripts, PassTheirOwnTests) {
  std::ostringstream out;
  const TestSummary summary = run_script_tests({}, kScripts, out);
  EXPECT_EQ(summary.failed, 0) << out.str();
  EXPECT_GE(summary.passed, 20);
}

}  // namespace
}  // namespace reorient
