// SPDX-License-Identifier: MIT
#include "program/run/live_run.h"

#include <utility>

#include "program/interruption.h"
#include "program/log.h"
#include "program/program.h"
#include "program/robots.h"
#include "program/safe_output.h"
#include "workbench/files/atomic_file.h"
#include "workbench/views/live/live_view.h"

namespace reorient {

LiveRun::LiveRun(const RunOptions& options, LiveConsole& console, std::ostream& out, std::ostream& err)
    : options_(options),
      console_(console),
      out_(out),
      err_(err),
      room_for_log_([this] { console_.make_room(); }),
      progress_(err, [this] { return console_.is_open(); }),
      timeline_(out, options.every_transition, [this] {
        progress_.make_room();
        console_.begin_line();
      }) {}

void LiveRun::tell(const std::string& line) {
  progress_.make_room();
  console_.make_room();
  print_error(err_, line);
}

RunEnd LiveRun::run(LiveRunParts live) {
  std::vector<Observer*>& observers = live.parts.observers;
  observers.insert(observers.end(), {&log_, &timeline_});
  if (!options_.model.empty())
    observers.push_back(&model_.emplace(options_.model, live.model, options_.sides_changed, live.mounting));
  const bool is_simulated = options_.robot == kSimulator || options_.robot == kFootage;
  if (live.recording) live.recording->application = live.parts.engine.application();
  recording_.emplace(
      std::move(live.recording), [this](const std::string& line) { tell(line); },
      is_simulated ? EarlierRecording::is_replaced : EarlierRecording::stays);
  if (Observer* const recorder = recording_->observer()) observers.push_back(recorder);
  observers.push_back(&progress_);
  if (live.edits != nullptr) {
    live.parts.sources.insert(live.parts.sources.begin(), {live.edits, &console_});
    observers.push_back(&console_);
  }
  if (live.live != nullptr) {
    live.parts.sources.insert(live.parts.sources.begin() + (live.edits != nullptr ? 2 : 0), live.live);
    observers.push_back(live.live);
  }
  if (live.live != nullptr) {
    // The user who tunes it needs time to save the values.
    live.parts.continues = [this, view = live.live, is_told = false]() mutable {
      if (!is_told && !view->has_viewers()) return false;
      if (!std::exchange(is_told, true))
        tell("the scenario is over; the run continues for its viewers, until Ctrl-C or --seconds");
      return true;
    };
  }
  live.parts.stop = [this, stop = std::move(live.parts.stop)] {
    return is_ended_by_hand(console_) || (stop && stop());
  };
  const RunEnd end = RunLoop(std::move(live.parts)).run();
  progress_.end();
  set_log_time({});
  return end;
}

void LiveRun::save_model(std::vector<std::string>& failures) {
  if (model_) try_to_write(failures, [&] { model_->save(); });
}

bool is_ended_by_hand(const LiveConsole& console) { return Interruption::signal() != 0 || console.wants_to_quit(); }

std::string user_who_ended_run(bool has_quit) {
  switch (Interruption::signal()) {
    case 0:
      return has_quit ? "its user with quit" : "";
    case SIGINT:
      return "its user with Ctrl-C";
    case SIGTERM:
      return "the signal SIGTERM";
    default:
      return "the signal SIGHUP";
  }
}

int exit_code_of_runs(const std::vector<std::string>& failures, bool succeeded) {
  if (!failures.empty()) return kBadInput;
  if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());
  return succeeded ? kSuccess : kWrong;
}

}  // namespace reorient
