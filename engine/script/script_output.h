// SPDX-License-Identifier: MIT
// The output of scripts in one frame. The names are in the host's table.
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
  NameId machine = 0;  ///< the empty name: the operator
  NameId state = 0;
  std::string text;
  int dropped = 0;       ///< lines after this one in the frame, beyond what a machine may log
  bool is_note = false;  ///< a note, which can be searched for in a recording
};
template <typename Visit, ConstOr<LogRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.machine, record.state, record.text, record.dropped, record.is_note);
}

/// A run-time error, and the host's reaction.
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

/// Result of an edit.
struct ReloadRecord {
  std::string script;                 ///< file, from the scripts' root
  bool accepted = false;              ///< false: the previous version keeps running
  ScriptFault fault;                  ///< if it was not accepted
  std::vector<std::string> warnings;  ///< removed states, clamped parameters, values that cannot be stored
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
