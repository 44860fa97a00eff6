// SPDX-License-Identifier: MIT
#include "program/command_line_error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "engine/parameters/nearest_name.h"
#include "program/help.h"
#include "workbench/files/home.h"

namespace reorient {
namespace {

/// A suggestion for an unknown word: an option, a subcommand, or a scenario to run.
std::string hint(const CLI::App& app, std::span<const Subcommand> subcommands) {
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) return {};
  std::vector<const CLI::App*> asked{&app};
  while (!asked.back()->get_subcommands().empty()) asked.push_back(asked.back()->get_subcommands().back());
  std::vector<std::string> known;
  if (unknown.front().starts_with("-")) {
    for (const CLI::App* parser : asked) {
      for (const CLI::Option* option : parser->get_options()) {
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
      }
    }
    return did_you_mean(unknown.front().substr(0, unknown.front().find('=')), known);
  }
  if (asked.size() > 1) return {};
  std::error_code error;
  if (std::filesystem::exists(find_home() / "scripts" / "scenarios" / (unknown.front() + ".lua"), error))
    return " (did you mean 'reorient run " + unknown.front() + "'?)";
  for (const Subcommand& subcommand : subcommands) known.push_back(subcommand.parser->get_name());
  return did_you_mean(unknown.front(), known);
}

/// The parts before and after the first `separator`. Not with std::regex, whose recursion a long word would overflow.
std::optional<std::pair<std::string, std::string>> split(const std::string& text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  return std::pair(text.substr(0, at), text.substr(at + separator.size()));
}

/// "a, b or c".
std::string either_of(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text.append(i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ").append(choices[i]);
  return text;
}

/// What to write instead of a value that CLI11 refuses with the text `why`.
std::string expected_value(const CLI::Option& option, const std::string& why) {
  if (const std::vector<std::string> choices = choices_of(option); !choices.empty()) {
    const auto refused = split(why, " not in {");
    return "expected " + either_of(choices) + ", found '" + (refused ? refused->first : why) + "'";
  }
  if (const auto range = split(why, " not in range "); range && range->first.starts_with("Value "))
    return "expected a number from " + range->second + ", found '" + range->first.substr(6) + "'";
  return why;
}

/// The description of what is missing, since its name alone may be unclear.
std::string missing_text(const CLI::App& asked, const std::string& what) {
  for (const CLI::Option* option : asked.get_options()) {
    if (what == option->get_name()) return "expected " + what + " (" + option->get_description() + "), found none";
  }
  return missing_command(asked);
}

/// CLI11's text in the form of our errors. Texts of a kind that this program does not cause stay as they are.
std::string reworded(const std::string& text, const CLI::App& asked) {
  if (const auto parts = split(text, " not expected: "); parts && text.starts_with("The following argument")) {
    const std::string& what = parts->second;
    const bool is_command = asked.get_parent() == nullptr;
    return (what.starts_with("-") ? "unknown option '"
            : is_command          ? "unknown command '"
                                  : "unexpected argument '") +
           what + "'";
  }
  if (const auto number = split(text, " = "); number && text.starts_with("Could not convert: "))
    return split(number->first, ": ")->second + ": expected a number, found '" + number->second + "'";
  if (text.ends_with(" is required")) return missing_text(asked, split(text, " is required")->first);
  if (!text.starts_with("-")) return text;
  if (const auto pair = split(text, " excludes -"))
    return pair->first + " and -" + pair->second + ": expected one, found both";
  if (const auto pair = split(text, " requires -"))
    return pair->first + ": expected together with -" + pair->second + ", found alone";
  const auto parts = split(text, ": ");
  const CLI::Option* const option = parts ? option_named(&asked, parts->first) : nullptr;
  if (option == nullptr || parts->second.find("expected") != std::string::npos) return text;
  if (parts->second.starts_with("1 required ") && text.ends_with(" missing"))
    return parts->first + ": expected a value (" + placeholder_of(*option) + "), found none";
  return parts->first + ": " + expected_value(*option, parts->second);
}

}  // namespace

const CLI::App& asked_of(const CLI::App& app) {
  const std::vector<CLI::App*> named = app.get_subcommands();
  return named.empty() ? app : asked_of(*named.back());
}

std::string missing_command(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : commands_of(app)) names.append(names.empty() ? "" : ", ").append(command->get_name());
  return "expected a command: " + names + "; found none";
}

std::string text_of(const CLI::ParseError& error, const CLI::App& app, std::span<const Subcommand> subcommands) {
  const CLI::App& asked = asked_of(app);
  const bool is_unknown = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  return reworded(error.what(), asked) + (is_unknown ? hint(app, subcommands) : "") + " (see " + path_of(asked) +
         " --help)";
}

}  // namespace reorient
