// SPDX-License-Identifier: MIT
// A script in the host.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/machine/machine.h"
#include "engine/script/script.h"
#include "geometry/const_or.h"

namespace reorient {

/// The state of its caller in which a called behavior runs, since when that was entered.
struct CallVisit {
  std::string state;  ///< path
  double entered_at = 0.0;
};
template <typename Visit, ConstOr<CallVisit> T>
void fields(Visit&& visit, T& call) {
  visit(call.state, call.entered_at);
}

/// How a called behavior ended.
struct CallEnd {
  BehaviorEnd how = BehaviorEnd::none;
  std::string reason;  ///< of the transition into the state that ended it
};
template <typename Visit, ConstOr<CallEnd> T>
void fields(Visit&& visit, T& end) {
  visit(end.how, end.reason);
}

/// One script: its current version, the last good one, and its state in the engine.
struct ScriptSlot {
  struct Running {
    Machine machine;
    std::string_view seen_state;  ///< at the start of the frame
    double seen_entered_at = 0.0;

    /// Takes over the state that the previous version had at the start of the frame, as a text of this version; the
    /// current state if that state was removed.
    void see_as(const Running& before) {
      const int same = machine.definition().find(std::string(before.seen_state));
      seen_state = same < 0 ? machine.state() : machine.definition().states[static_cast<std::size_t>(same)].path;
      seen_entered_at = same < 0 ? machine.entered_at() : before.seen_entered_at;
    }
  };

  std::string file;
  std::unique_ptr<Script> script;
  std::unique_ptr<Script> last_good;  ///< while the current version is within its trial_time
  BundleHashes read;                  ///< the files as they were last read, accepted or not
  std::vector<Running> machines;
  double swapped_at = 0.0;
  int recent_errors = 0;
  int errors = 0;
  double last_error_at = 0.0;
  std::string last_error;
  bool stopped = false;
  std::int64_t frames = 0;
  std::int64_t instructions_before = 0;
  double microseconds = 0.0;

  // Of a behavior that another one runs (script_calls.cpp). Its machines are one.
  std::optional<CalledAs> called;
  ScriptSlot* caller = nullptr;      ///< nullptr: it was loaded by name
  std::vector<ScriptSlot*> callees;  ///< of all machines
  std::optional<CallVisit> visit;    ///< nothing: the caller is not in a state that runs it
  CallEnd end;                       ///< of the latest visit; none: it has not ended, or was left before
  std::vector<CallArgument> given;   ///< of a behavior that was loaded by name
  bool was_refused = false;          ///< its latest version was not accepted
  std::string spare;                 ///< memory of the next visit's text
  bool has_other_calls = false;      ///< a rollback has replaced the version that declares its callees

  // The texts of visits and ends use their memory again, so that no frame needs the heap.
  void leave() {
    if (visit) spare.swap(visit->state);
    visit.reset();
  }
  void visit_from(std::string_view state, double entered_at) {
    leave();
    visit.emplace().state.swap(spare);
    visit->state = state;
    visit->entered_at = entered_at;
  }
  void set_end(BehaviorEnd how, std::string_view reason) {
    end.how = how;
    end.reason = reason;
  }

  Machine* machine_named(std::string_view name) {
    for (Running& running : machines) {
      if (running.machine.definition().name == name) return &running.machine;
    }
    return nullptr;
  }
  /// Whether its machines run: it is not stopped, and neither are its callers, which are in states that run it.
  bool is_running() const {
    if (stopped) return false;
    return caller == nullptr ||
           (visit && machines.front().machine.outcome() == BehaviorEnd::none && caller->is_running());
  }
};

/// Bounds what all scripts may use together, because a recording brings the limits of its scripts. Call it before a
/// version of `slot` is compiled with `limits`. Throws ScriptError.
void require_room(const std::vector<std::unique_ptr<ScriptSlot>>& slots, const ScriptSlot& slot,
                  const ScriptLimits& limits);

}  // namespace reorient
