// SPDX-License-Identifier: MIT
// `reorient version`.
#include <ostream>

#include <CLI/CLI.hpp>

#include "program/program.h"
#include "program/subcommand.h"

namespace reorient {

Subcommand add_version(CLI::App& program) {
  return {program.add_subcommand("version", "print the version"), [](std::ostream& out, std::ostream&) {
            out << "reorient " << REORIENT_VERSION << '\n';
            return kSuccess;
          }};
}

}  // namespace reorient
