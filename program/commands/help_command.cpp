// SPDX-License-Identifier: MIT
// `reorient help`: the page of a command, or the manual page of all commands.
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "engine/parameters/nearest_name.h"
#include "program/help.h"
#include "program/program.h"
#include "program/shell/man_page.h"
#include "program/subcommand.h"

namespace reorient {
namespace {

const CLI::App& command_named(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* asked = &program;
  std::string name;
  for (const std::string& word : words) {
    name.append(name.empty() ? "" : " ").append(word);
    std::vector<std::string> known;
    const CLI::App* found = nullptr;
    for (const CLI::App* command : commands_of(*asked)) {
      known.push_back(command->get_name());
      if (command->get_name() == word) found = command;
    }
    if (found == nullptr) throw std::runtime_error("unknown command '" + name + "'" + did_you_mean(word, known));
    asked = found;
  }
  return *asked;
}

}  // namespace

Subcommand add_help(CLI::App& program) {
  struct HelpOptions {
    std::vector<std::string> words;
    bool man = false;
  };
  const auto options = std::make_shared<HelpOptions>();
  CLI::App* const parser = program.add_subcommand("help", "print the help of a command");
  set_examples(*parser,
               {{"reorient help", "the list of commands"},
                {"reorient help room rate", "the same as 'reorient room rate --help'"},
                {"reorient help --man > reorient.1", "all pages as a manual page; read it with man ./reorient.1"}});
  parser->add_option("command", options->words, "command (default: the program)")->type_name("COMMAND");
  parser->add_flag("--man", options->man, "print the manual page of all commands");
  return {parser, [options, &program](std::ostream& out, std::ostream&) {
            const CLI::App& asked = command_named(program, options->words);
            if (options->man && !options->words.empty())
              throw std::runtime_error("--man: expected no command, found '" + options->words.front() + "'");
            out << (options->man ? man_page(program) : help_text(asked));
            return kSuccess;
          }};
}

}  // namespace reorient
