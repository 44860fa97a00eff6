// A host that runs scripts of a temporary folder frame by frame.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/script/script_error.h"
#include "engine/script/script_host.h"
#include "tests/temporary_folder.h"

namespace reorient {

class ScriptTest : public ::testing::Test {
 protected:
  static constexpr double kStep = 1.0 / 30.0;

  ScriptHost& host() {
    if (!host_) host_ = std::make_unique<ScriptHost>(folder.path(), parameters, limits);
    return *host_;
  }

  /// Writes behaviors/NAME.lua and loads it.
  void load(const std::string& name, const std::string& text) {
    folder.write("behaviors/" + name + ".lua", text);
    host().load_behavior(name);
  }

  /// What loading this behaviour is refused with.
  ScriptFault refusal(const std::string& text) {
    folder.write("behaviors/refused.lua", text);
    try {
      host().load_behavior("refused");
    } catch (const ScriptError& error) {
      return error.fault;
    }
    return {"", 0, "it was accepted", ""};
  }

  const ScriptOutput& tick() {
    world.time_step = kStep;
    const ScriptOutput& output = host().tick(world);
    for (const TransitionRecord& record : output.transitions) transitions.push_back(record);
    for (const LogRecord& record : output.logs) logs.push_back(record.text);
    for (const FaultRecord& record : output.faults) faults.push_back(record);
    for (const CommandRequest& request : output.commands) commands.push_back(request);
    world.time += kStep;
    ++world.frame;
    return output;
  }
  /// So many frames.
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }

  MachineStatus status(const std::string& machine) {
    for (const MachineStatus& one : host().machines()) {
      if (one.name == machine) return one;
    }
    ADD_FAILURE() << "there is no machine " << machine;
    return {};
  }
  std::string state(const std::string& machine) { return status(machine).state; }

  /// Saves another version of behaviors/NAME.lua and swaps it in.
  ReloadReport edit(const std::string& name, const std::string& text) {
    folder.write("behaviors/" + name + ".lua", text);
    const std::vector<ReloadReport> reports = host().reload_changed(world.time);
    if (reports.size() == 1) return reports.front();
    ADD_FAILURE() << "expected one reload, saw " << reports.size();
    return {};
  }

  TemporaryFolder folder;
  ParameterRegistry parameters;
  ScriptLimits limits;
  World world;
  std::vector<TransitionRecord> transitions;
  std::vector<std::string> logs;
  std::vector<FaultRecord> faults;
  std::vector<CommandRequest> commands;

 private:
  std::unique_ptr<ScriptHost> host_;
};

}  // namespace reorient
