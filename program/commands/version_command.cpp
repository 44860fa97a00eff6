// SPDX-License-Identifier: MIT
// `reorient version`.
#include <ostream>

#include <CLI/CLI.hpp>

#include "program/help.h"
#include "program/program.h"
#include "program/subcommand.h"

namespace reorient {

Subcommand add_version(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("version", "print the version");
  set_examples(*parser, {{"reorient version", "the version"}, {"reorient --version", "the same"}});
  return {parser, [](std::ostream& out, std::ostream&) {
            out << "reorient " << REORIENT_VERSION << '\n';
            return kSuccess;
          }};
}

}  // namespace reorient
