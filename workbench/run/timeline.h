// The events of a run in words: commands, pauses and changes of state. It takes a bounded memory: of each machine the
// latest events are kept, the older ones only counted.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "workbench/run/observer.h"

namespace reorient {

struct TimelineEvent {
  double time = 0.0;        ///< s
  std::uint64_t order = 0;  ///< among all events
  std::string machine;
  std::string state;    ///< path; of a change: "from > to"
  std::string command;  ///< empty: a change of state
  std::string reason;
  std::string verdict;
};

/// What one machine did.
struct MachineEvents {
  std::deque<TimelineEvent> transitions;  ///< the latest
  std::deque<TimelineEvent> commands;     ///< the latest, pauses among them
  std::uint64_t transition_count = 0;
  std::uint64_t command_count = 0;
};

class Timeline : public Observer {
 public:
  void observe(const FrameRecord& frame, const StageRecord& stage) override;

  const std::map<std::string, MachineEvents>& machines() const { return machines_; }
  /// All commands that are kept, in the order of time.
  std::vector<TimelineEvent> commands() const;

  static constexpr std::size_t kMostOfAMachine = 500;  ///< of each kind
  static constexpr std::size_t kMostMachines = 200;    ///< names may change with every edit

 private:
  MachineEvents& events_of(const std::string& machine);
  void note_transitions(const NameTable& names, const std::vector<TransitionRecord>& transitions, double time);
  void note_command(const NameTable& names, const Issuer& issuer, std::string_view command, std::string_view verdict,
                    double time);

  std::map<std::string, MachineEvents> machines_;
  std::uint64_t order_ = 0;
};

}  // namespace reorient
