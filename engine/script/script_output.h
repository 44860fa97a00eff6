// SPDX-License-Identifier: MIT
// What scripts of any kind said in one frame. The names stand in the host's table.
#pragma once

#include <string>
#include <vector>

#include "engine/script/sandbox/sandbox.h"
#include "engine/world/names.h"
#include "geometry/const_or.h"

namespace reorient {

struct TransitionRecord {
  NameId machine = 0;
  NameId from = 0;  ///< path; the empty name at the start
  NameId to = 0;
  NameId reason = 0;    ///< the transition's `because`
  int transition = -1;  ///< of the machine's definition; -1: the start, or after a reload
};
template <typename Visit, ConstOr<TransitionRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.machine, record.from, record.to, record.reason, record.transition);
}

struct LogRecord {
  NameId machine = 0;  ///< the empty name: a person
  NameId state = 0;
  std::string text;
  int dropped = 0;       ///< lines after this one in the frame, beyond what a machine may log
  bool is_note = false;  ///< to be found again by whoever looks at the run later
};
template <typename Visit, ConstOr<LogRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.machine, record.state, record.text, record.dropped, record.is_note);
}

/// A run-time error, and what the host did about it.
struct FaultRecord {
  enum class Consequence { none, rolled_back, stopped };
  friend constexpr int enum_count(Consequence) { return 3; }

  std::string script;  ///< file, from the scripts' root
  ScriptFault fault;
  Consequence consequence = Consequence::none;
};
template <typename Visit, ConstOr<FaultRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.script, record.fault, record.consequence);
}

/// What became of an edit.
struct ReloadRecord {
  std::string script;                 ///< file, from the scripts' root
  bool accepted = false;              ///< false: the previous version keeps running
  ScriptFault fault;                  ///< where it was not accepted
  std::vector<std::string> warnings;  ///< states that are gone, parameters that were clamped, memory left out
};
template <typename Visit, ConstOr<ReloadRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.script, record.accepted, record.fault, record.warnings);
}

struct ScriptOutput {
  std::vector<TransitionRecord> transitions;
  std::vector<LogRecord> logs;
  std::vector<FaultRecord> faults;

  void clear() {
    transitions.clear();
    logs.clear();
    faults.clear();
  }
};

}  // namespace reorient
