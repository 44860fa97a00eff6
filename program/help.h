// SPDX-License-Identifier: MIT
// The pages that `reorient COMMAND --help` prints.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace reorient {

/// The type name without the descriptions of the checks that follow it: "N" of "N:{320,640}".
std::string placeholder_of(const CLI::Option& option);
/// The values that a check of the option allows: "320", "640"; empty: any, or a range.
std::vector<std::string> choices_of(const CLI::Option& option);
/// "reorient room rate".
std::string path_of(const CLI::App& app);
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// Formats the page of each command: usage, purpose, commands, arguments, options by group, examples. The placeholder
/// of an option is its type name; choices, range and default come from the option itself. Subcommands inherit the
/// formatter.
class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

 protected:
  struct Entry {
    std::string name;  ///< "--seed N"
    std::string text;
    bool is_required = false;
  };

  /// Whether the page lists this option or argument.
  virtual bool is_listed(const CLI::Option& option) const;
  virtual Entry entry_of(const CLI::Option& option) const;
  /// The page's path with its fixed options: "reorient room rate".
  virtual std::string command_of(const CLI::App& app) const;
  /// One paragraph below the options; empty: none.
  virtual std::string note() const { return {}; }
  virtual std::string examples_of(const CLI::App& app) const;
};

struct Example {
  std::string command;
  std::string effect;
};

/// The examples as they stand on the page. `end`: a paragraph below them.
std::string examples_text(std::initializer_list<Example> examples, const std::string& end = {});
/// Replaces the examples that the parser has inherited.
void set_examples(CLI::App& parser, std::initializer_list<Example> examples, const std::string& end = {});

}  // namespace reorient
