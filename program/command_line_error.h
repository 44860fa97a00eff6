// SPDX-License-Identifier: MIT
// What is wrong with a command line, in the form of all errors: what was expected, what was found, where.
#pragma once

#include <span>
#include <string>

#include "program/subcommand.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace reorient {

/// The innermost subcommand on the command line, or the program.
const CLI::App& asked_of(const CLI::App& app);

/// "expected a command: compare, merge; found none", with the commands of the program or of a command.
std::string missing_command(const CLI::App& app);

/// One line, such as "--width: expected 160, 320 or 640, found '3' (see reorient run --help)". Suggests the nearest
/// known word for an unknown one. `subcommands`: those of the program.
std::string text_of(const CLI::ParseError& error, const CLI::App& app, std::span<const Subcommand> subcommands);

}  // namespace reorient
