// SPDX-License-Identifier: MIT
#include "workbench/scenario/parameter_edits.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace reorient {
namespace {

constexpr std::size_t kMostUndoable = 1000;

bool is_valid(const ParameterChange& change, const Parameter& parameter) {
  if (change.origin == ParameterOrigin::default_value) return true;
  try {
    static_cast<void>(parse_parameter(parameter, change.value));
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

RequestedChange request_change(const ParameterChange& change, ScenarioHost* scenario, FrameInputs& inputs) {
  const auto earlier = std::count_if(inputs.parameter_changes.begin(), inputs.parameter_changes.end(),
                                     [&](const ParameterChange& one) { return one.name == change.name; });
  inputs.parameter_changes.push_back(change);
  return {change.name, static_cast<std::size_t>(earlier),
          scenario != nullptr ? scenario->change(change) : std::nullopt};
}

ParameterOutcome outcome_of_change(const RequestedChange& change, const FrameRecord& frame) {
  ParameterOutcome outcome{change.name, {}, {}};
  std::size_t earlier = change.earlier;
  for (const ParameterOutcome& one : frame.parameter_changes) {
    if (one.name != change.name) continue;
    outcome = one;
    if (earlier-- == 0) break;
  }
  if (change.by_scenario) outcome = *change.by_scenario;  // the engine may not have this parameter
  if (outcome.value.empty()) outcome.refusal = change.name + " is fixed during a run; set it with --set";
  return outcome;
}

ParameterChange change_back_to(const Parameter& present, const FrameInputs& inputs) {
  const std::vector<ParameterChange>& changes = inputs.parameter_changes;
  const auto last = std::find_if(changes.rbegin(), changes.rend(), [&](const ParameterChange& one) {
    return one.name == present.name && is_valid(one, present);
  });
  if (last != changes.rend()) return {last->name, last->value, last->origin, ""};
  const bool is_default = present.origin == ParameterOrigin::default_value;
  return {present.name, to_text(present.value), is_default ? present.origin : ParameterOrigin::live, ""};
}

std::uint64_t UndoableChanges::add(ParameterChange back) {
  if (entries_.size() == kMostUndoable) entries_.erase(entries_.begin());
  entries_.push_back({++added_, std::move(back)});
  return added_;
}

void UndoableChanges::remove(std::uint64_t number) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.number == number; });
}

std::optional<ParameterChange> UndoableChanges::take_last() {
  if (entries_.empty()) return std::nullopt;
  ParameterChange back = std::move(entries_.back().back);
  entries_.pop_back();
  return back;
}

}  // namespace reorient
