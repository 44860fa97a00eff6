#include "engine/program/test_command.h"

#include "engine/program/program.h"
#include "engine/script/test_runner.h"

namespace reorient {

int run_tests(const TestOptions& options, std::ostream& out) {
  const TestSummary summary = run_script_tests(options.paths, options.scripts, out);
  return summary.failed == 0 ? kSuccess : kWrong;
}

}  // namespace reorient
