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
/// The option of this name of the command, or of one above it; nullptr: unknown.
const CLI::Option* option_named(const CLI::App* command, const std::string& name);
/// Its commands, without hidden ones.
std::vector<const CLI::App*> commands_of(const CLI::App& app);

/// `text` behind `name`, which is indented by two blanks; each line of the text begins at `column`, counted from 0, and
/// ends before column 100. Without a name the text begins at the margin.
std::string wrapped(const std::string& name, const std::string& text, std::size_t column);

/// The content of the page of one command.
struct HelpPage {
  struct Entry {
    std::string name;  ///< "--seed N"
    std::string text;
    bool is_required = false;
  };
  struct Group {
    std::string name;
    std::vector<Entry> options;
  };
  std::string command;             ///< "reorient room rate"
  std::vector<std::string> usage;  ///< one line for each way to call it
  std::string purpose;             ///< a sentence
  std::vector<Entry> commands, arguments;
  std::vector<Group> groups;
  std::string note;      ///< one paragraph; may be empty
  std::string examples;  ///< lines as they are printed; may be empty
};

/// Formats the page of each command: usage, purpose, commands, arguments, options by group, examples. The placeholder
/// of an option is its type name; choices, range and default come from the option itself. Subcommands inherit the
/// formatter.
class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

  /// All pages of the command: one, unless its options depend on the value of one of them.
  virtual std::vector<HelpPage> pages_of(const CLI::App& app) const { return {page_of(app)}; }

 protected:
  HelpPage page_of(const CLI::App& app) const;
  /// Whether the page lists this option or argument.
  virtual bool is_listed(const CLI::Option& option) const;
  virtual HelpPage::Entry entry_of(const CLI::Option& option) const;
  /// The page's path with its fixed options: "reorient room rate".
  virtual std::string command_of(const CLI::App& app) const;
  virtual std::string note() const { return {}; }
  virtual std::string examples_of(const CLI::App& app) const;
};

/// The page that `--help` of this command prints.
std::string help_text(const CLI::App& app);
/// The pages of the command and, below it, of its subcommands, in the order of the list of commands.
std::vector<HelpPage> all_pages_of(const CLI::App& app);

struct Example {
  std::string command;
  std::string effect;
};

/// The examples as they stand on the page. `end`: a paragraph below them.
std::string examples_text(std::initializer_list<Example> examples, const std::string& end = {});
/// Replaces the examples that the parser has inherited.
void set_examples(CLI::App& parser, std::initializer_list<Example> examples, const std::string& end = {});

}  // namespace reorient
