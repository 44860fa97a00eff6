// SPDX-License-Identifier: MIT
// All commands of the prompt in one table, which dispatch, help and completion read.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "program/run/console/command.h"
#include "program/run/console/operator_commands.h"
#include "program/run/console/parameter_commands.h"
#include "program/run/console/script_commands.h"
#include "program/run/console/world_commands.h"

namespace reorient {

/// The objects that commands act on.
struct ConsoleSubject {
  ScenarioHost* scenario = nullptr;                                 ///< may be nullptr
  std::function<std::vector<Parameter>()> parameters;               ///< all existing parameters
  std::function<std::vector<ParameterChange>()> kept_parameters{};  ///< of scripts that are not loaded; may be empty
  std::function<const ScriptTexts*()> scripts{};                    ///< as last read from the disk
  std::function<const FrameLoop*()> engine{};                       ///< nullptr: no robot; may be empty
  RunControls* controls = nullptr;                                  ///< nullptr: a replay
};

class CommandTable {
 public:
  explicit CommandTable(ConsoleSubject subject);
  CommandTable(const CommandTable&) = delete;
  CommandTable& operator=(const CommandTable&) = delete;

  /// `typed`: a command with its arguments. Throws std::runtime_error with one line if it cannot be executed.
  Reply obey(const Words& typed, FrameInputs& inputs);
  /// Completions for the next word after these.
  Words candidates(const Words& before) const;

  /// Call in each frame, after the answer: unrequested output, such as watched values, as whole lines.
  std::string observe(const FrameRecord& frame, const SceneTruth& scene);

  bool wants_to_quit() const { return quit_; }
  /// The requests of the user; nullptr: a replay.
  const RunControls* controls() const { return controls_; }

 private:
  const Command& find(const std::string& name) const;
  std::string help(const std::string& name) const;
  Words names() const;

  ParameterCommands parameters_;
  WorldCommands world_;
  ScriptCommands scripts_;
  RunControls* controls_;
  std::shared_ptr<const ApplicationInterface> application_;  ///< of the last frame
  std::vector<Command> commands_;
  bool quit_ = false;
};

}  // namespace reorient
