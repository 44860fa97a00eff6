// SPDX-License-Identifier: MIT
#include "program/help.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "program/options.h"

namespace reorient {
namespace {

constexpr std::size_t kColumns = 100, kTextColumn = 26, kExampleColumn = 62;

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text.back() == '?' ? text : text + ".";
}

bool takes_several(const CLI::Option& option) {
  return option.get_allow_extra_args() && option.get_expected_max() == CLI::detail::expected_max_vector_size;
}

std::string with_dots(const std::string& placeholder, const CLI::Option& option) {
  return takes_several(option) && !placeholder.ends_with("...") ? placeholder + "..." : placeholder;
}

/// The values that the checks of the option allow: ": a, b" or ", 1 to 254"; empty if the text names all choices.
std::string allowed_by(const CLI::Option& option, const std::string& text) {
  if (const std::vector<std::string> all = choices_of(option); !all.empty()) {
    std::string choices;
    bool are_named = true;
    for (const std::string& choice : all) {
      are_named = are_named && text.find(choice) != std::string::npos;
      choices.append(choices.empty() ? ": " : ", ").append(choice);
    }
    return are_named ? "" : choices;
  }
  const std::string type = option.get_type_name();
  constexpr std::string_view kIn = " in [", kDash = " - ";
  const std::size_t open = type.find(kIn);
  if (open == std::string::npos) return {};
  const std::string range = type.substr(open + kIn.size(), type.find(']', open) - open - kIn.size());
  const std::size_t dash = range.find(kDash);
  return ", " + range.substr(0, dash) + " to " + range.substr(dash + kDash.size());
}

/// "[hall,same]" of a list is "hall,same".
std::string default_of(const CLI::Option& option) {
  const std::string text = option.get_type_size() == 0 ? "" : option.get_default_str();
  return text.starts_with('[') && text.ends_with(']') ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::string wrapped(const std::string& name, const std::string& text, std::size_t column) {
  std::string page = name.empty() ? "" : "  " + name;
  std::string line = page;
  const auto end_line = [&] {
    page += "\n";
    line.clear();
  };
  if (line.size() + 2 > column && column > 0) end_line();
  bool is_first = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    if (!is_first && line.size() + 1 + word.size() > kColumns) {
      end_line();
      is_first = true;
    }
    std::string addition = is_first ? std::string(column - std::min(column, line.size()), ' ') : " ";
    addition += word;
    page += addition;
    line += addition;
    is_first = false;
  }
  return page + "\n";
}

std::string placeholder_of(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // "N:{160,320,544}"
  const std::size_t open = type.find(":{");
  if (open == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 2, type.find('}') - open - 2), ',');
}

std::string path_of(const CLI::App& app) {
  const CLI::App* const parent = app.get_parent();
  return parent == nullptr ? app.get_name() : path_of(*parent) + " " + app.get_name();
}

const CLI::Option* option_named(const CLI::App* command, const std::string& name) {
  const CLI::Option* option = nullptr;
  for (; option == nullptr && command != nullptr; command = command->get_parent())
    option = command->get_option_no_throw(name);
  return option;
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

bool HelpFormatter::is_listed(const CLI::Option& option) const { return !option.get_group().empty(); }

HelpPage::Entry HelpFormatter::entry_of(const CLI::Option& option) const {
  std::string name;
  for (const std::string& letter : option.get_snames()) name.append(name.empty() ? "-" : ", -").append(letter);
  for (const std::string& word : option.get_lnames()) name.append(name.empty() ? "--" : ", --").append(word);
  const std::string placeholder = with_dots(placeholder_of(option), option);
  if (!placeholder.empty()) name.append(name.empty() ? "" : " ").append(placeholder);

  constexpr const char* kDefault = " (default: ";
  const std::string& description = option.get_description();
  const std::size_t end = std::min(description.rfind(kDefault), description.size());
  std::string text = description.substr(0, end);
  text += allowed_by(option, text);
  const std::string value = default_of(option);
  text += value.empty() ? description.substr(end) : kDefault + value + ")";
  if (option.get_required() && !option.get_positional()) text += " (required)";
  return {name, text, option.get_required()};
}

std::string HelpFormatter::command_of(const CLI::App& app) const { return path_of(app); }

HelpPage HelpFormatter::page_of(const CLI::App& app) const {
  HelpPage page{.command = command_of(app),
                .usage = {},
                .purpose = sentence(app.get_description()),
                .commands = {},
                .arguments = {},
                .groups = {},
                .note = note(),
                .examples = examples_of(app)};
  const auto add = [&page](const std::string& name, HelpPage::Entry entry) {
    const auto group =
        std::find_if(page.groups.begin(), page.groups.end(), [&](const auto& one) { return one.name == name; });
    if (group != page.groups.end())
      group->options.push_back(std::move(entry));
    else
      page.groups.push_back({name, {std::move(entry)}});
  };
  for (const CLI::Option* option : app.get_options()) {
    if (option == app.get_help_ptr() || !is_listed(*option)) continue;
    if (option->get_positional())
      page.arguments.push_back(entry_of(*option));
    else
      add(option->get_group(), entry_of(*option));
  }
  const std::string own = app.get_help_ptr()->get_group();
  add(own != kPlainGroup || page.groups.empty() ? own
      : page.groups.size() == 1                 ? page.groups.front().name
                                                : "Help",
      entry_of(*app.get_help_ptr()));

  for (const CLI::App* command : commands_of(app))
    page.commands.push_back({command->get_name(), command->get_description()});
  std::string usage = page.command + " [OPTIONS]";
  // An argument is optional for the parser also because a command may take its place.
  for (const HelpPage::Entry& argument : page.arguments)
    usage += argument.is_required || !page.commands.empty() ? " " + argument.name : " [" + argument.name + "]";
  if (!page.commands.empty() && page.arguments.empty()) usage += " COMMAND";
  page.usage.push_back(usage);
  if (!page.commands.empty() && !page.arguments.empty()) page.usage.push_back(page.command + " COMMAND");
  return page;
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string /*name*/, CLI::AppFormatMode /*mode*/) const {
  const HelpPage page = page_of(*app);
  std::string text;
  for (const std::string& usage : page.usage) text.append(text.empty() ? "Usage: " : "       ").append(usage) += '\n';
  text += "\n" + wrapped("", page.purpose, 0);
  if (!page.commands.empty()) text += "\nCommands:\n";
  std::size_t column = 0;
  for (const HelpPage::Entry& command : page.commands) column = std::max(column, command.name.size() + 4);
  for (const HelpPage::Entry& command : page.commands) text += wrapped(command.name, command.text, column);
  if (!page.arguments.empty()) text += "\nArguments:\n";
  for (const HelpPage::Entry& argument : page.arguments) text += wrapped(argument.name, argument.text, kTextColumn);
  for (const HelpPage::Group& group : page.groups) {
    text += "\n" + group.name + ":\n";
    for (const HelpPage::Entry& option : group.options) text += wrapped(option.name, option.text, kTextColumn);
  }
  if (!page.note.empty()) text += "\n" + wrapped("", page.note, 0);
  if (!page.examples.empty()) text += "\n" + page.examples;
  return text;
}

std::string help_text(const CLI::App& app) {
  return app.get_formatter()->make_help(&app, app.get_name(),
                                        CLI::AppFormatMode::Normal);  // App::help() asks the parsed command
}

std::vector<HelpPage> all_pages_of(const CLI::App& app) {
  const auto* const formatter = dynamic_cast<const HelpFormatter*>(app.get_formatter().get());
  std::vector<HelpPage> pages = formatter != nullptr ? formatter->pages_of(app) : std::vector<HelpPage>();
  for (const CLI::App* command : commands_of(app)) {
    for (HelpPage& page : all_pages_of(*command)) pages.push_back(std::move(page));
  }
  return pages;
}

std::string HelpFormatter::examples_of(const CLI::App& app) const { return app.get_footer(); }

std::string examples_text(std::initializer_list<Example> examples, const std::string& end) {
  std::size_t column = 0;
  for (const Example& example : examples) column = std::max(column, example.command.size() + 4);
  std::string text = "Examples:\n";
  for (const Example& example : examples)
    text += wrapped(example.command, example.effect, std::min(column, kExampleColumn));
  if (!end.empty()) text += "\n" + wrapped("", end, 0);
  return text;
}

void set_examples(CLI::App& parser, std::initializer_list<Example> examples, const std::string& end) {
  parser.footer(examples_text(examples, end));
}

}  // namespace reorient
