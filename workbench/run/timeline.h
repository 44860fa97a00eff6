// SPDX-License-Identifier: MIT
// The events of a run as text: commands, pauses, changes of state and notes.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "workbench/run/observer.h"

namespace reorient {

struct TimelineEvent {
  double time = 0.0;    ///< s
  std::string machine;  ///< or "game", or "note" (of the operator)
  std::string state;    ///< path; of a change: "from > to"; of a note: "note: " and its text
  std::string command;  ///< empty: a change of state, or a note
  std::string reason;
  std::string verdict;
  bool reorients = false;  ///< a granted flip, purge or reset
};

/// The events of one frame in order: a change of state comes before the commands that it caused.
std::vector<TimelineEvent> timeline_events(const FrameRecord& frame, const SceneTruth& scene);

/// The commands and pauses of a run, in bounded memory: stores the latest of each machine and counts the older
/// ones.
class CommandHistory : public Observer {
 public:
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// All stored events in order of time.
  std::vector<TimelineEvent> commands() const;
  std::uint64_t dropped() const;  ///< number of events that are not stored

  static constexpr std::size_t kMostOfAMachine = 500;
  static constexpr std::size_t kMostMachines = 200;  ///< names may change with every edit

 private:
  struct Commands {
    std::deque<std::pair<std::uint64_t, TimelineEvent>> kept;  ///< with their number among all events
    std::uint64_t count = 0;
  };
  Commands& commands_of(const std::string& machine);

  std::map<std::string, Commands> machines_;
  std::uint64_t count_ = 0;
};

}  // namespace reorient
