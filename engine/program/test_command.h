// `reorient test`: scripted behaviour tests.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

namespace reorient {

struct TestOptions {
  std::vector<std::filesystem::path> paths;  ///< files or folders; none: tests/ of the scripts
  std::filesystem::path scripts;             ///< root of the scripts
};

/// Returns the exit code.
int run_tests(const TestOptions& options, std::ostream& out);

}  // namespace reorient
