// SPDX-License-Identifier: MIT
// `reorient check`: finds mistakes in scripts without running them.
#include <memory>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/help.h"
#include "program/options.h"
#include "program/program.h"
#include "program/subcommand.h"
#include "workbench/script_tools/check/script_check.h"

namespace reorient {
namespace {

struct CheckOptions {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path scripts;
  bool strict = false;
};

int check(const CheckOptions& options, std::ostream& out) {
  const std::filesystem::path root = scripts_root(options.scripts);
  const CheckResult result = check_scripts(root, options.paths);
  if (result.files == 0) throw std::runtime_error(root.string() + ": expected scripts, found none");
  for (const Finding& finding : result.findings) out << as_line(finding.text()) << "\n";
  const int errors = result.count(Finding::Severity::error);
  const int warnings = result.count(Finding::Severity::warning);
  out << counted(result.files, "script") << " checked: " << counted(errors, "error") << ", "
      << counted(warnings, "warning") << "\n";
  return errors > 0 || (options.strict && warnings > 0) ? kWrong : kSuccess;
}

}  // namespace

Subcommand add_check(CLI::App& program) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* const parser =
      program.add_subcommand("check", "find mistakes in scripts without running them")->fallthrough();
  set_examples(*parser,
               {{"reorient check", "mistakes in all scripts, with line and column"},
                {"reorient check scripts/behaviors/orientation.lua --strict", "one script; warnings are errors"}});
  parser->add_option("paths", options->paths, "files or folders whose findings are printed (default: all scripts)")
      ->type_name("PATH");
  parser->add_flag("--strict", options->strict, "treat warnings as errors");
  add_scripts_option(*parser, options->scripts, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream&) { return check(*options, out); }};
}

}  // namespace reorient
