// SPDX-License-Identifier: MIT
#include "workbench/recording/what_if.h"

#include <algorithm>
#include <map>

#include "engine/record/record_bytes.h"
#include "workbench/recording/replay.h"

namespace reorient {
namespace {

/// The states of the machines since the last look.
class StateWatch {
 public:
  void note(const FrameRecord& frame, std::vector<std::pair<std::string, std::string>>& changes) {
    for (const MachineStatus& machine : frame.machines) {
      std::string state = machine.state == kNoName ? "" : frame.name(machine.state);
      if (machine.stopped) state += " (stopped)";
      const std::string& name = frame.name(machine.machine);
      const auto [known, is_new] = last_.try_emplace(name, state);
      if (!is_new && known->second == state) continue;
      known->second = state;
      changes.emplace_back(name, std::move(state));
    }
  }

 private:
  std::map<std::string, std::string> last_;
};

WhatIfMoment moment_of(const FrameRecord& frame, StateWatch& watch) {
  const auto& confidence = frame.world.confidence;
  WhatIfMoment moment{confidence.evidence, confidence.current, confidence.opposite, frame.world.room_status, {}};
  watch.note(frame, moment.states);
  return moment;
}

/// Both runs side by side, from the frame on in which the changes are applied.
class BothRuns : public Observer {
 public:
  BothRuns(const Playback& playback, const WhatIfSource& source, WhatIfAnswer& answer)
      : playback_(playback), source_(source), answer_(answer) {}

  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    if (!source_.has_begun()) return;
    const FrameRecord recorded = read_record(playback_.frame().entry.record);
    answer_.frames.push_back({frame.world.time, moment_of(recorded, recorded_), moment_of(frame, tried_)});
  }

 private:
  const Playback& playback_;
  const WhatIfSource& source_;
  WhatIfAnswer& answer_;
  StateWatch recorded_, tried_;
};

template <typename Values, typename Changed>
void leave_out_changed(Values& values, const Changed& changed, auto name_of) {
  std::erase_if(values, [&](const auto& value) {
    return std::any_of(changed.begin(), changed.end(), [&](const auto& one) { return name_of(one) == name_of(value); });
  });
}

}  // namespace

void WhatIfSource::add_to(FrameInputs& inputs) {
  if (inputs.observation.time < from_) return;
  leave_out_changed(inputs.parameter_changes, changes_.parameters, [](const auto& change) { return change.name; });
  leave_out_changed(inputs.script_edits, changes_.scripts, [](const auto& edit) { return edit.file; });
  if (std::exchange(has_begun_, true)) return;
  inputs.parameter_changes.insert(inputs.parameter_changes.end(), changes_.parameters.begin(),
                                  changes_.parameters.end());
  inputs.script_edits.insert(inputs.script_edits.end(), changes_.scripts.begin(), changes_.scripts.end());
}

void RequireTaken::observe(const FrameRecord& frame, const SceneTruth& /*scene*/) {
  if (!source_.has_begun() || std::exchange(is_checked_, true)) return;
  const WhatIfChanges& changes = source_.changes();
  for (const ParameterOutcome& outcome : frame.parameter_changes) {
    const bool is_ours = std::any_of(changes.parameters.begin(), changes.parameters.end(),
                                     [&](const ParameterChange& change) { return change.name == outcome.name; });
    if (is_ours && !outcome.refusal.empty()) throw std::runtime_error(outcome.refusal);
  }
  if (changes.scripts.empty()) return;
  for (const ReloadRecord& reload : frame.reloads) {
    if (!reload.accepted) throw std::runtime_error(reload.script + ": " + reload.fault.text());
  }
}

WhatIfAnswer what_if(FrameSource& frames, const WhatIfQuestion& question, const std::function<bool()>& stop) {
  WhatIfAnswer answer;
  Replay replay(frames, question.from, question.to);
  WhatIfSource source(question.changes, question.from);
  BothRuns both(replay.playback(), source, answer);
  ReplayComparison comparison(replay.playback());
  while (replay.next_stretch() != nullptr) {
    source.begin_again();
    RequireTaken taken(source);
    replay.run({&source}, {&taken, &comparison, &both}, stop);
    if (stop && stop()) throw WhatIfStopped("what_if: it was stopped");
  }
  if (answer.frames.empty())
    throw std::runtime_error("what_if: no frame of this time is kept any more (see --live-memory)");
  answer.has_gap = replay.stretches() > 1 || replay.playback().skipped() > 0;
  // The frames before the changes are replayed only to get there.
  for (const ReplayComparison::Event& event : comparison.events()) {
    if (event.time >= answer.frames.front().time) answer.events.push_back(event);
  }
  answer.first_decision = comparison.first_decision();
  answer.first_action = comparison.first_action();
  return answer;
}

}  // namespace reorient
