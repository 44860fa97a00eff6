#include "workbench/run/timeline.h"

#include <algorithm>

namespace reorient {
namespace {

void keep(std::deque<TimelineEvent>& events, std::uint64_t& count, TimelineEvent event) {
  events.push_back(std::move(event));
  ++count;
  if (events.size() > Timeline::kMostOfAMachine) events.pop_front();
}

}  // namespace

void Timeline::observe(const FrameRecord& frame, const StageRecord& stage) {
  const double time = frame.world.time;
  note_transitions(*frame.names, frame.transitions, time);
  for (const Lease& lease : frame.begun)
    note_command(*frame.names, lease.issuer, to_string(lease.pause), to_string(Verdict::granted), time);
  for (const CommandRecord& command : frame.commands) {
    note_command(*frame.names, command.request.issuer, to_string(command.request.reorientation),
                 to_string(command.verdict), time);
  }
  note_transitions(*stage.scenario.names, stage.scenario.transitions, time);
}

MachineEvents& Timeline::events_of(const std::string& machine) {
  const auto found = machines_.find(machine);
  if (found != machines_.end() || machines_.size() < kMostMachines) return machines_[machine];
  return machines_["(others)"];
}

void Timeline::note_transitions(const NameTable& names, const std::vector<TransitionRecord>& transitions, double time) {
  for (const TransitionRecord& record : transitions) {
    MachineEvents& events = events_of(names[record.machine]);
    keep(events.transitions, events.transition_count,
         {time, order_++, names[record.machine], names[record.from] + " > " + names[record.to], "",
          names[record.reason], ""});
  }
}

void Timeline::note_command(const NameTable& names, const Issuer& issuer, std::string_view command,
                            std::string_view verdict, double time) {
  MachineEvents& events = events_of(names[issuer.machine]);
  keep(events.commands, events.command_count,
       {time, order_++, names[issuer.machine], names[issuer.state], std::string(command), names[issuer.reason],
        std::string(verdict)});
}

std::vector<TimelineEvent> Timeline::commands() const {
  std::vector<TimelineEvent> all;
  for (const auto& [name, events] : machines_) all.insert(all.end(), events.commands.begin(), events.commands.end());
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.order < b.order; });
  return all;
}

}  // namespace reorient
