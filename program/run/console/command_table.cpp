// SPDX-License-Identifier: MIT
#include "program/run/console/command_table.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

/// The smallest and the largest number of arguments of a command.
std::pair<std::size_t, std::size_t> argument_counts(std::string_view arguments) {
  std::istringstream in{std::string(arguments)};
  std::size_t least = 0, most = 0;
  for (std::string word; in >> word; ++most) {
    least += word.starts_with('[') ? 0 : 1;
    if (word.ends_with("...")) return {least, std::numeric_limits<std::size_t>::max()};
  }
  return {least, most};
}

std::string usage(const Command& command) {
  return command.arguments.empty() ? std::string(command.name) : fmt::format("{} {}", command.name, command.arguments);
}

/// The help of a command that is too long for its column is in the next line, as in the help of options.
std::string help_line(const std::string& command, std::string_view help) {
  constexpr std::size_t kColumn = 20;
  return command.size() <= kColumn ? fmt::format("  {:<{}}  {}\n", command, kColumn, help)
                                   : fmt::format("  {}\n  {:<{}}  {}\n", command, "", kColumn, help);
}

std::string optional_argument(const Words& arguments) { return arguments.empty() ? std::string() : arguments[0]; }

/// Seconds of the robot's time to wait. Throws std::runtime_error.
double seconds_of(const std::string& text) {
  constexpr double kLongest = 36000.0;
  const ParameterDeclaration wanted{"wait", ParameterKind::real, 0.0, 0.0, kLongest, "s", "", {}};
  return std::get<double>(parse_parameter(wanted, text));
}

/// `set NAME=VALUE`, the form of --set, as `set NAME VALUE`.
Words with_value_apart(Words words) {
  const std::size_t sign = words.size() == 2 && words[0] == "set" ? words[1].find('=') : std::string::npos;
  if (sign == std::string::npos) return words;
  words.push_back(words[1].substr(sign + 1));
  words[1].resize(sign);
  return words;
}

Reply note(const Words& words, FrameInputs& inputs) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  inputs.external.notes.push_back(text);
  return [](const FrameRecord& frame, const SceneTruth&) {
    return fmt::format("  noted at {:.2f} s\n", frame.world.time);
  };
}

Reply wait(double seconds) {
  return [seconds, until = std::optional<double>()](const FrameRecord& frame,
                                                    const SceneTruth&) mutable -> std::optional<std::string> {
    if (!until) until = frame.world.time + seconds;
    constexpr double kTolerance = 1e-6;  // frame times are sums of rounded steps
    if (frame.world.time + kTolerance < *until) return std::nullopt;
    return std::string();
  };
}

/// Of the engine that runs already, if any.
ApplicationInterface application_of(const ConsoleSubject& subject) {
  const FrameLoop* const engine = subject.engine ? subject.engine() : nullptr;
  return engine != nullptr ? engine->application() : ApplicationInterface();
}

}  // namespace

CommandTable::CommandTable(ConsoleSubject subject)
    : parameters_(subject.scenario, std::move(subject.parameters), std::move(subject.kept_parameters)),
      world_(application_of(subject)),
      scripts_(subject.scenario, std::move(subject.scripts), std::move(subject.engine)),
      controls_(subject.controls) {
  const auto parameter_or_value = [this](const Words& before) {
    return before.empty() ? parameters_.names() : before.size() == 1 ? parameters_.values(before[0]) : Words();
  };
  const auto first = [](auto names) {
    return [names](const Words& before) { return before.empty() ? Words(names()) : Words(); };
  };
  commands_ = {
      {"set", "NAME VALUE", "change a parameter, as in: set decision.false_flips 1",
       [this](const Words& words, FrameInputs& inputs) { return parameters_.set(words[0], words[1], inputs); },
       parameter_or_value},
      {"undo", "", "undo the last change of a parameter; again: the one before",
       [this](const Words&, FrameInputs& inputs) { return parameters_.undo(inputs); }},
      {"params", "[PATTERN]", "parameters with value, range and origin, as in: params orientation",
       [this](const Words& words, FrameInputs&) { return parameters_.list(optional_argument(words)); },
       first([this] { return parameters_.names(); })},
      {"diff", "", "parameters that differ from their defaults",
       [this](const Words&, FrameInputs&) { return parameters_.differences(); }},
      {"save", "FILE", "save the parameters that differ from their defaults, for --params FILE",
       [this](const Words& words, FrameInputs&) { return parameters_.save(words[0]); }},
      {"world", "[PATTERN]", "world fields and their values now, as in: world pose.*",
       [this](const Words& words, FrameInputs&) { return world_.look(optional_argument(words)); },
       first([this] { return world_.names(); })},
      {"watch", "[PATTERN]", "print these values when they change; alone: list the watched values",
       [this](const Words& words, FrameInputs&) { return world_.watch(optional_argument(words)); },
       first([this] { return world_.names(); })},
      {"unwatch", "[PATTERN]", "stop watching these values; alone: all",
       [this](const Words& words, FrameInputs&) { return world_.unwatch(optional_argument(words)); },
       first([this] { return world_.watched(); })},
      {"states", "", "state and cost of each behavior",
       [](const Words&, FrameInputs&) { return ScriptCommands::states(); }},
      {"why", "MACHINE", "transitions of a behavior's state, and what their conditions lack",
       [this](const Words& words, FrameInputs&) { return scripts_.why(words[0]); },
       first([this] { return scripts_.machines(); })},
      {"reload", "[SCRIPT]", "reload a script, or all, even if unchanged",
       [this](const Words& words, FrameInputs& inputs) { return scripts_.reload(optional_argument(words), inputs); },
       first([this] { return scripts_.scripts(); })},
      {"note", "TEXT...", "record a note at this time, as in: note the referee moved it",
       [](const Words& words, FrameInputs& inputs) { return note(words, inputs); }},
      {"wait", "SECONDS", "wait before the next command, in the robot's time",
       [this](const Words& words, FrameInputs&) {
         if (is_paused(controls_)) throw std::runtime_error("wait: expected a run that is not paused; resume it first");
         return wait(seconds_of(words[0]));
       }},
      {"help", "[COMMAND]", "this list",
       [this](const Words& words, FrameInputs&) { return at_once(help(optional_argument(words))); },
       first([this] { return names(); })},
      {"quit", "", "end the run",
       [this](const Words&, FrameInputs&) {
         quit_ = true;
         return at_once("");
       }},
  };
  // Before `wait`.
  const std::vector<Command> more = operator_commands(controls_);
  const auto wait =
      std::find_if(commands_.begin(), commands_.end(), [](const auto& one) { return one.name == "wait"; });
  commands_.insert(wait, more.begin(), more.end());
}

Reply CommandTable::obey(const Words& typed, FrameInputs& inputs) {
  const Words words = with_value_apart(typed);
  const Command& command = find(words.front());
  const auto [least, most] = argument_counts(command.arguments);
  const Words arguments(words.begin() + 1, words.end());
  if (arguments.size() < least || arguments.size() > most) throw std::runtime_error("expected " + usage(command));
  return command.act(arguments, inputs);
}

Words CommandTable::candidates(const Words& before) const {
  if (before.empty()) return names();
  for (const Command& command : commands_) {
    if (command.name == before.front() && command.candidates)
      return command.candidates(Words(before.begin() + 1, before.end()));
  }
  return {};
}

std::string CommandTable::observe(const FrameRecord& frame, const SceneTruth& scene) {
  scripts_.observe(frame, scene);
  if (application_ != frame.application.declared) {
    application_ = frame.application.declared;
    world_.take_application(*application_);
  }
  return world_.changes(frame);
}

const Command& CommandTable::find(const std::string& name) const {
  const auto found =
      std::find_if(commands_.begin(), commands_.end(), [&](const Command& command) { return command.name == name; });
  if (found == commands_.end())
    throw std::runtime_error("unknown command '" + name + "'" + did_you_mean(name, names()) + "; help lists them");
  return *found;
}

std::string CommandTable::help(const std::string& name) const {
  std::string text;
  for (const Command& command : commands_) {
    if (name.empty() || command.name == name) text += help_line(usage(command), command.help);
  }
  if (text.empty()) find(name);
  if (name.empty()) text += help_line("(an empty line)", "close the prompt; the run continues");
  return text;
}

Words CommandTable::names() const {
  Words all;
  for (const Command& command : commands_) all.emplace_back(command.name);
  return all;
}

}  // namespace reorient
