// SPDX-License-Identifier: MIT
#include "program/shell/completion.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "program/help.h"
#include "program/options.h"
#include "program/parameter_list.h"
#include "program/shell/catalog.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

/// What the value of an option or argument names, if it is not one of a fixed list of choices.
constexpr std::pair<std::string_view, const char*> kCatalogOf[] = {
    {"scenario", "scenarios"}, {"--with", "behaviors"},       {"--without", "behaviors"}, {"--body", "bodies"},
    {"--field", "fields"},     {"--interface", "interfaces"}, {"--params", "parameters"}, {"--rooms", "rooms"},
    {"--room", "rooms"},       {"experiment", "experiments"}, {"--mode", "conditions"},   {"--motion", "conditions"},
};

/// The words of a command line up to the one that is completed.
struct Parsed {
  const CLI::App* command = nullptr;
  const CLI::Option* option = nullptr;  ///< whose value is completed
  std::size_t arguments = 0;            ///< positional ones before it
  std::filesystem::path scripts;        ///< of --scripts
};

bool takes_value(const CLI::Option* option) { return option != nullptr && option->get_items_expected_min() > 0; }

Parsed parsed(const CLI::App& program, std::span<const std::string> words) {
  Parsed result{.command = &program, .option = nullptr, .arguments = 0, .scripts = {}};
  for (const std::string& word : words) {
    if (word.starts_with('-')) {
      const CLI::Option* const option = option_named(result.command, word.substr(0, word.find('=')));
      result.option = takes_value(option) && word.find('=') == std::string::npos ? option : nullptr;
      continue;
    }
    if (const CLI::Option* const option = result.option) {
      if (option->check_name("--scripts")) result.scripts = word;
      if (option->get_expected_max() <= 1 || !option->get_allow_extra_args()) result.option = nullptr;
      continue;
    }
    const std::vector<const CLI::App*> commands = commands_of(*result.command);
    const auto named = std::find_if(commands.begin(), commands.end(),
                                    [&](const CLI::App* command) { return command->get_name() == word; });
    if (named != commands.end() && result.arguments == 0) {
      result.command = *named;
    } else {
      ++result.arguments;
    }
  }
  return result;
}

/// The argument that the next word without a dash is; nullptr: none is expected.
const CLI::Option* argument_of(const Parsed& line) {
  std::size_t position = 0;
  const CLI::Option* last = nullptr;
  for (const CLI::Option* option : line.command->get_options()) {
    if (!option->get_positional()) continue;
    last = option;
    if (position++ == line.arguments) return option;
  }
  return last != nullptr && last->get_expected_max() > 1 ? last : nullptr;
}

class Collected {
 public:
  explicit Collected(std::string prefix) : prefix_(std::move(prefix)) {}

  void add(const std::string& word, const std::string& text = {}) {
    if (word.starts_with(prefix_)) result.candidates.push_back({word, text});
  }
  Completion result;

 private:
  std::string prefix_;
};

/// `before`: what stands before the value in the same word, as "--body=".
void add_values(const CLI::App& program, const CLI::Option& option, const std::string& before,
                const std::filesystem::path& scripts, Collected& collected) {
  const std::vector<std::string> choices = choices_of(option);
  for (const std::string& choice : choices) collected.add(before + choice);
  if (!choices.empty()) return;
  for (const auto& [name, kind] : kCatalogOf) {
    if (!option.check_name(std::string(name))) continue;
    for (const CatalogEntry& entry : catalog_kind(kind)->entries(scripts))
      collected.add(before + entry.name, entry.text);
  }
  if (option.check_name("--set")) {
    for (const Parameter& parameter : all_parameters(read_scripts(scripts), {}, {}, {}))
      collected.add(before + parameter.name + "=", parameter.description);
  }
  if (option.check_name("command")) {
    for (const CLI::App* command : commands_of(program)) collected.add(command->get_name(), command->get_description());
  }
  if (option.check_name("kind")) {
    for (const CatalogKind& kind : catalog()) collected.add(before + kind.name, kind.use);
  }
  const std::string placeholder = placeholder_of(option);
  const bool names_a_path = placeholder.starts_with("FILE") || placeholder == "PATH" || placeholder == "SOURCE" ||
                            placeholder == "PAGE" || placeholder == "TABLE" || placeholder == "SCRIPT" ||
                            placeholder == "EXPERIMENT" || placeholder == "SCENARIO" || placeholder == "ROOM";
  collected.result.files = names_a_path;
  collected.result.folders = names_a_path || placeholder == "FOLDER";
}

}  // namespace

Completion completion_of(const CLI::App& program, std::span<const std::string> words) {
  const std::string word = words.empty() ? std::string() : words.back();
  const Parsed line = parsed(program, words.first(words.empty() ? 0 : words.size() - 1));
  Collected collected(word);
  try {
    const std::filesystem::path scripts = scripts_root(line.scripts, Scripts::may_come);
    if (word.starts_with('-')) {
      const std::size_t equals = word.find('=');
      const CLI::Option* const option =
          equals == std::string::npos ? nullptr : option_named(line.command, word.substr(0, equals));
      if (takes_value(option)) {
        add_values(program, *option, word.substr(0, equals + 1), scripts, collected);
        return std::move(collected.result);
      }
      for (const CLI::App* app = line.command; app != nullptr; app = app->get_parent()) {
        for (const CLI::Option* one : app->get_options()) {
          if (one->get_group().empty() || (app != line.command && one == app->get_help_ptr())) continue;
          for (const std::string& name : one->get_lnames()) collected.add("--" + name, one->get_description());
        }
      }
      return std::move(collected.result);
    }
    if (line.option != nullptr) {
      add_values(program, *line.option, {}, scripts, collected);
      if (line.option->get_expected_max() <= 1 || !line.option->get_allow_extra_args())
        return std::move(collected.result);
    }
    if (line.arguments == 0) {
      for (const CLI::App* command : commands_of(*line.command))
        collected.add(command->get_name(), command->get_description());
    }
    if (const CLI::Option* const argument = argument_of(line)) add_values(program, *argument, {}, scripts, collected);
  } catch (const std::exception&) {
    // A folder of scripts that cannot be read gives no candidates; the command itself reports it.
  }
  return std::move(collected.result);
}

}  // namespace reorient
