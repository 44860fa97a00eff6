// SPDX-License-Identifier: MIT
#include "workbench/run/timeline.h"

#include <algorithm>
#include <utility>

namespace reorient {
namespace {

void append_transitions(const NameTable& names, const std::vector<TransitionRecord>& transitions, double time,
                        std::vector<TimelineEvent>& events) {
  for (const TransitionRecord& record : transitions) {
    const std::string& from = names[record.from];
    const std::string change =
        (from.empty() ? "> " : from + " > ") + (record.to == kNoName ? "stopped" : names[record.to]);
    events.push_back({time, names[record.machine], change, "", names[record.reason], "", false});
  }
}

TimelineEvent command_event(const NameTable& names, const Issuer& issuer, std::string_view command, Verdict verdict,
                            double time) {
  TimelineEvent event{time, names[issuer.machine], names[issuer.state], std::string(command), names[issuer.reason], "",
                      false};
  event.verdict = to_string(verdict);
  return event;
}

void append_notes(const NameTable& names, const std::vector<LogRecord>& logs, double time,
                  std::vector<TimelineEvent>& events) {
  for (const LogRecord& line : logs) {
    if (!line.is_note) continue;
    const std::string& machine = names[line.machine];
    events.push_back({time, machine.empty() ? "note" : machine, "note: " + line.text, "", "", "", false});
  }
}

}  // namespace

std::vector<TimelineEvent> timeline_events(const FrameRecord& frame, const SceneTruth& scene) {
  const double time = frame.world.time;
  std::vector<TimelineEvent> events;
  if (frame.inputs.half_time) events.push_back({time, "game", "half-time", "", "the teams change sides", "", false});
  append_notes(*frame.names, frame.logs, time, events);
  append_transitions(*frame.names, frame.transitions, time, events);
  for (const Lease& lease : frame.begun)
    events.push_back(command_event(*frame.names, lease.issuer, to_string(lease.pause), Verdict::granted, time));
  for (const CommandRecord& command : frame.commands) {
    events.push_back(command_event(*frame.names, command.request.issuer, to_string(command.request.reorientation),
                                   command.verdict, time));
    events.back().reorients = command.verdict == Verdict::granted;
  }
  for (const ActionRecord& record : frame.application.requests) {
    const DeclaredAction& action = frame.application.declared->actions[record.request.action];
    events.push_back(command_event(*frame.names, record.request.issuer,
                                   "action " + to_text(action, record.request.arguments), record.verdict, time));
  }
  append_notes(*scene.scenario.names, scene.scenario.logs, time, events);
  append_transitions(*scene.scenario.names, scene.scenario.transitions, time, events);
  return events;
}

void CommandHistory::observe(const FrameRecord& frame, const SceneTruth& scene) {
  for (TimelineEvent& event : timeline_events(frame, scene)) {
    if (event.command.empty()) continue;
    Commands& commands = commands_of(event.machine);
    commands.kept.emplace_back(count_++, std::move(event));
    ++commands.count;
    if (commands.kept.size() > kMostOfAMachine) commands.kept.pop_front();
  }
}

CommandHistory::Commands& CommandHistory::commands_of(const std::string& machine) {
  const auto found = machines_.find(machine);
  if (found != machines_.end() || machines_.size() < kMostMachines) return machines_[machine];
  return machines_["(others)"];
}

std::vector<TimelineEvent> CommandHistory::commands() const {
  std::vector<std::pair<std::uint64_t, TimelineEvent>> all;
  for (const auto& [name, commands] : machines_) all.insert(all.end(), commands.kept.begin(), commands.kept.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TimelineEvent> events;
  events.reserve(all.size());
  for (auto& [place, event] : all) events.push_back(std::move(event));
  return events;
}

std::uint64_t CommandHistory::dropped() const {
  std::uint64_t dropped = 0;
  for (const auto& [name, commands] : machines_) dropped += commands.count - commands.kept.size();
  return dropped;
}

}  // namespace reorient
