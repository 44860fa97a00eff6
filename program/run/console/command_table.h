// SPDX-License-Identifier: MIT
// All commands of the prompt in one table, which dispatch, help and completion read.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "program/run/console/command.h"
#include "program/run/console/parameter_commands.h"
#include "program/run/console/script_commands.h"
#include "program/run/console/world_commands.h"

namespace reorient {

/// What the commands act on.
struct ConsoleSubject {
  ScenarioHost* scenario = nullptr;                                 ///< may be nullptr
  std::function<std::vector<Parameter>()> parameters;               ///< all that there are
  std::function<std::vector<ParameterChange>()> kept_parameters{};  ///< of scripts that are not there; may be empty
  std::filesystem::path scripts{};                                  ///< their root
};

class CommandTable {
 public:
  explicit CommandTable(ConsoleSubject subject);
  CommandTable(const CommandTable&) = delete;
  CommandTable& operator=(const CommandTable&) = delete;

  /// `words`: a command with its arguments. Throws std::runtime_error with one line where it cannot be obeyed.
  Reply obey(const Words& words, FrameInputs& inputs);
  /// What the next word may be, behind these.
  Words candidates(const Words& before) const;

  /// Each frame, behind the answer to it: what is to be told without having been asked for just now, as whole lines.
  std::string observe(const FrameRecord& frame, const SceneTruth& scene);

  bool wants_to_quit() const { return quit_; }

 private:
  const Command& find(const std::string& name) const;
  std::string help(const std::string& name) const;
  Words names() const;

  ParameterCommands parameters_;
  WorldCommands world_;
  ScriptCommands scripts_;
  std::vector<Command> commands_;
  bool quit_ = false;
};

}  // namespace reorient
