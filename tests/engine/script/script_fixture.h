// SPDX-License-Identifier: MIT
// Runs behaviors frame by frame from texts in memory, and records their results with names as texts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/script/behaviors.h"
#include "engine/script/script_error.h"

namespace reorient {

struct TickedTransition {
  double time = 0.0;
  std::string machine;
  std::string from;
  std::string to;
  std::string reason;
  int transition = -1;
};
struct TickedLease {
  Pause pause = Pause::training;
  std::string machine;
  std::string state;
  std::string reason;
};
struct TickedCommand {
  Reorientation reorientation = Reorientation::flip_pose;
  std::string machine;
  std::string state;
  std::string reason;
  double priority = 0.0;
};
struct TickedStatus {
  std::string state;
  bool stopped = false;
  int errors = 0;
  double time_in_state = 0.0;
  double microseconds = 0.0;
  std::int64_t instructions = 0;
  std::size_t memory = 0;
};
/// Requests and events of one frame.
struct SeenTick {
  Request request;
  std::vector<TickedLease> leases;
  std::vector<TickedCommand> commands;
  std::vector<TickedTransition> transitions;
  std::vector<FaultRecord> faults;
};

/// Saved files that the scripts get with the next reload.
class SavedFiles {
 public:
  void write(const std::string& file, std::string text) { edits_.push_back({file, ScriptText{std::move(text), ""}}); }
  void remove(const std::string& file) { edits_.push_back({file, std::nullopt}); }
  std::vector<ScriptEdit> take() { return std::exchange(edits_, {}); }

 private:
  std::vector<ScriptEdit> edits_;
};

class ScriptTest : public ::testing::Test {
 protected:
  static constexpr double kStep = 1.0 / 30.0;

  Behaviors& behaviors() {
    if (!behaviors_) behaviors_ = std::make_unique<Behaviors>(ScriptTexts(), parameters, limits);
    return *behaviors_;
  }
  ScriptHost& host() { return behaviors().host(); }

  /// Saves behaviors/NAME.lua and loads it.
  void load(const std::string& name, const std::string& text) {
    folder.write("behaviors/" + name + ".lua", text);
    reload();
    host().load(name);
  }

  /// The error with which this behavior is refused.
  ScriptFault refusal(const std::string& text) {
    folder.write("behaviors/refused.lua", text);
    reload();
    try {
      host().load("refused");
    } catch (const ScriptError& error) {
      return error.fault;
    }
    return {"", 0, "the script was accepted", ""};
  }

  const SeenTick& tick() {
    world.time_step = kStep;
    behaviors().tick(world);
    const Names& names = host().names();
    seen_ = {};
    seen_.request = behaviors().wanted().request;
    for (const Lease& lease : behaviors().leases()) {
      const Issuer& who = lease.issuer;
      seen_.leases.push_back({lease.pause, names[who.machine], names[who.state], names[who.reason]});
    }
    for (const ReorientationRequest& request : behaviors().wanted().commands) {
      const Issuer& who = request.issuer;
      seen_.commands.push_back(
          {request.reorientation, names[who.machine], names[who.state], names[who.reason], request.priority});
    }
    const ScriptOutput& said = behaviors().said();
    for (const TransitionRecord& t : said.transitions) {
      seen_.transitions.push_back(
          {world.time, names[t.machine], names[t.from], names[t.to], names[t.reason], t.transition});
    }
    seen_.faults = said.faults;
    transitions.insert(transitions.end(), seen_.transitions.begin(), seen_.transitions.end());
    for (const LogRecord& record : said.logs) logs.push_back(record.text);
    faults.insert(faults.end(), said.faults.begin(), said.faults.end());
    commands.insert(commands.end(), seen_.commands.begin(), seen_.commands.end());
    world.time += kStep;
    ++world.frame;
    return seen_;
  }
  /// Runs this many frames.
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }

  TickedStatus status(const std::string& machine) {
    const Names& names = host().names();
    std::vector<MachineStatus> all;
    std::vector<MachineCost> costs;
    host().read_status(all);
    host().read_costs(costs);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (names[all[i].machine] != machine) continue;
      return {names[all[i].state],   all[i].stopped,        all[i].errors,  world.time - kStep - all[i].entered_at,
              costs[i].microseconds, costs[i].instructions, costs[i].memory};
    }
    ADD_FAILURE() << "unknown machine " << machine;
    return {};
  }
  std::string state(const std::string& machine) { return status(machine).state; }

  /// Applies the saved files.
  std::vector<ReloadRecord> reload() {
    const std::vector<ScriptEdit> edits = folder.take();
    return host().apply(edits);
  }
  /// Saves another version of behaviors/NAME.lua and swaps it in.
  ReloadRecord edit(const std::string& name, const std::string& text) {
    folder.write("behaviors/" + name + ".lua", text);
    const std::vector<ReloadRecord> reports = reload();
    if (reports.size() == 1) return reports.front();
    ADD_FAILURE() << "expected 1 reload, found " << reports.size();
    return {};
  }

  SavedFiles folder;
  ParameterRegistry parameters;
  ScriptLimits limits;
  World world;
  std::vector<TickedTransition> transitions;
  std::vector<std::string> logs;
  std::vector<FaultRecord> faults;
  std::vector<TickedCommand> commands;

 private:
  std::unique_ptr<Behaviors> behaviors_;
  SeenTick seen_;
};

}  // namespace reorient
