// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/simulation.h"

namespace reorient {
namespace {

/// Stores only the latest of each type, so that a long run needs no more memory.
template <typename Seen>
void forget_the_oldest(std::vector<Seen>& seen) {
  constexpr std::ptrdiff_t kKept = 10'000;
  if (seen.size() > 2 * kKept) seen.erase(seen.begin(), seen.end() - kKept);
}

}  // namespace

void SeenFrames::note(const NameTable& names, std::span<const TransitionRecord> taken,
                      std::span<const LogRecord> logged, std::span<const FaultRecord> failed) {
  for (const TransitionRecord& record : taken) transitions.push_back({names[record.machine], names[record.reason]});
  for (const LogRecord& record : logged) logs.push_back(record.text);
  for (const FaultRecord& record : failed) faults.push_back(record.fault);
  forget_the_oldest(transitions);
  forget_the_oldest(logs);
  forget_the_oldest(faults);
}

void SeenFrames::note_messages(std::span<const std::string> sent) {
  messages.insert(messages.end(), sent.begin(), sent.end());
  forget_the_oldest(messages);
}

void SeenFrames::note_commands(std::span<const CommandRecord> given, std::span<const Lease> begun) {
  for (const Lease& lease : begun)
    commands.push_back({std::string(to_string(lease.pause)), std::string(to_string(Verdict::granted)), false});
  for (const CommandRecord& record : given) {
    commands.push_back(
        {std::string(to_string(record.request.reorientation)), std::string(to_string(record.verdict)), true});
  }
  forget_the_oldest(commands);
}

void SeenFrames::note_scenario(const ScenarioRecord& scenario) {
  note(*scenario.names, scenario.transitions, scenario.logs, scenario.faults);
  for (const OperatorAction& action : scenario.actions) actions.emplace_back(to_string(action.kind));
  forget_the_oldest(actions);
  verdict = scenario.verdict;
}

void SeenFrames::note_machines(const NameTable& names, std::span<const MachineStatus> statuses) {
  for (const MachineStatus& status : statuses) machines.push_back({names[status.machine], names[status.state]});
}

void SeenObserver::observe(const FrameRecord& frame, const SceneTruth& scene) {
  seen.note(*frame.names, frame.transitions, frame.logs, frame.faults);
  seen.note_messages(frame.answer.messages);
  seen.note_commands(frame.commands, frame.begun);
  seen.note_scenario(scene.scenario);
}

void SeenObserver::finish(const FrameRecord& last, const SceneTruth& scene) {
  seen.note_machines(*last.names, last.machines);
  seen.note_machines(*scene.scenario.names, scene.scenario.machines);
}

}  // namespace reorient
