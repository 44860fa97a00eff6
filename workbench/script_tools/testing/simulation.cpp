#include "workbench/script_tools/testing/simulation.h"

namespace reorient {

void SeenFrames::note(const NameTable& names, std::span<const TransitionRecord> taken, std::span<const LogRecord> said,
                      std::span<const FaultRecord> failed) {
  for (const TransitionRecord& record : taken) transitions.push_back({names[record.machine], names[record.reason]});
  for (const LogRecord& record : said) logs.push_back(record.text);
  for (const FaultRecord& record : failed) faults.push_back(record.fault);
}

void SeenFrames::note_commands(std::span<const CommandRecord> given, std::span<const Lease> begun) {
  for (const Lease& lease : begun)
    commands.push_back({std::string(to_string(lease.pause)), std::string(to_string(Verdict::granted)), false});
  for (const CommandRecord& record : given) {
    commands.push_back(
        {std::string(to_string(record.request.reorientation)), std::string(to_string(record.verdict)), true});
  }
}

void SeenFrames::note_scenario(const ScenarioRecord& scenario) {
  note(*scenario.names, scenario.transitions, scenario.logs, scenario.faults);
  for (const ExperimenterAction& action : scenario.actions) actions.emplace_back(to_string(action.kind));
  verdict = scenario.verdict;
}

void SeenFrames::note_machines(const NameTable& names, std::span<const MachineStatus> statuses) {
  for (const MachineStatus& status : statuses) machines.push_back({names[status.machine], names[status.state]});
}

void SeenObserver::observe(const FrameRecord& frame, const StageRecord& stage) {
  seen.note(*frame.names, frame.transitions, frame.logs, frame.faults);
  seen.note_commands(frame.commands, frame.begun);
  seen.note_scenario(stage.scenario);
}

void SeenObserver::finish(const FrameRecord& last, const StageRecord& stage) {
  seen.note_machines(*last.names, last.machines);
  seen.note_machines(*stage.scenario.names, stage.scenario.machines);
}

}  // namespace reorient
