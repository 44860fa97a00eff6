// SPDX-License-Identifier: MIT
// The declared values as they were set last, and the declared actions as they go on. An application that sends wrong,
// old or no values cannot make a behavior fail: a value always has its type and range.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/world/commands.h"
#include "geometry/const_or.h"
#include "robots/application.h"

namespace reorient {

struct ValueState {
  FieldData data;                                            ///< the last one that fits its declaration, or the default
  std::uint32_t records = 1;                                 ///< of a list
  double set_at = -std::numeric_limits<double>::infinity();  ///< s, when `data` was set
  bool fits = true;                                          ///< false: the last set value did not
  std::uint64_t revision = 0;                                ///< counts the changes of `data`
};
template <typename Visit, ConstOr<ValueState> T>
void fields(Visit&& visit, T& value) {
  visit(value.data, value.records, value.set_at, value.fits, value.revision);
}

/// The latest start of an action.
struct ActionStatus {
  std::uint32_t id = 0;  ///< 0: never started
  ActionState state = ActionState::idle;
  double since = 0.0;       ///< s, when the state began
  double started_at = 0.0;  ///< s
  std::string reason;       ///< of a failure
  FieldData arguments;
  Issuer issuer;
  double priority = 0.0;  ///< of the issuer
};
template <typename Visit, ConstOr<ActionStatus> T>
void fields(Visit&& visit, T& status) {
  visit(status.id, status.state, status.since, status.started_at, status.reason, status.arguments, status.issuer,
        status.priority);
}

struct ActionRequest {
  std::uint16_t action = 0;  ///< index in ApplicationInterface::actions
  FieldData arguments;       ///< that fit the declaration
  Issuer issuer;
  double priority = 0.0;          ///< of the behavior; the greater wins
  NameId outranked_by = kNoName;  ///< the machine that has a part of the body which the action moves
};
template <typename Visit, ConstOr<ActionRequest> T>
void fields(Visit&& visit, T& request) {
  visit(request.action, request.arguments, request.issuer, request.priority, request.outranked_by);
}

/// A request and its result in the same frame: granted, outranked, or too soon because the action still runs.
struct ActionRecord {
  ActionRequest request;
  Verdict verdict = Verdict::granted;
};
template <typename Visit, ConstOr<ActionRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.request, record.verdict);
}

/// A behavior's latest request of an action, if it was refused: its action has failed, whatever another behavior's
/// does.
struct RefusedAction {
  NameId machine = kNoName;
  std::uint16_t action = 0;
  NameId outranked_by = kNoName;  ///< nothing: the action already runs with other arguments
  double since = 0.0;             ///< s
};
template <typename Visit, ConstOr<RefusedAction> T>
void fields(Visit&& visit, T& refused) {
  visit(refused.machine, refused.action, refused.outranked_by, refused.since);
}

/// Whether the value fits its declaration and is not too old. `time`: s.
bool is_valid(const ValueState& state, const DeclaredValue& declared, double time);

/// Throws BadBytes if values or actions that were read do not fit the declarations.
void check_fits(std::span<const ValueState> values, std::span<const ActionStatus> actions,
                const ApplicationInterface& declared);

class ApplicationState {
 public:
  /// Throws std::runtime_error with one line if the declarations have a mistake.
  explicit ApplicationState(ApplicationInterface declared = {});

  const ApplicationInterface& declared() const { return *declared_; }
  std::shared_ptr<const ApplicationInterface> shared_declared() const { return declared_; }
  std::span<const ValueState> values() const { return values_; }
  std::span<const ActionStatus> actions() const { return actions_; }

  /// Whether such a request continues what the action does now, instead of starting it again.
  bool continues(std::size_t action, const FieldData& arguments) const {
    return is_under_way(actions_[action].state) && actions_[action].arguments == arguments;
  }

  /// s since the value was set; infinite if never. `time`: s.
  double age(std::size_t value, double time) const { return time - values_[value].set_at; }
  bool is_valid(std::size_t value, double time) const {
    return reorient::is_valid(values_[value], declared_->values[value], time);
  }

  // One frame, in this order. `time`: s.

  /// Continues actions whose time has passed.
  void begin_frame(double time);
  /// Appends one line per value that does not fit its declaration to `mistakes`, when that begins.
  void take(std::span<const SetValue> set, double time, std::vector<std::string>& mistakes);
  void take(std::span<const ActionReport> reports, double time);
  /// Starts the requested actions. A request for an action that runs with the same arguments continues it, and has no
  /// record.
  void start(std::span<const ActionRequest> requests, double time);

  /// nullptr: the latest request of this machine was granted, or it has requested none.
  const RefusedAction* refused(NameId machine, std::size_t action) const;
  /// Maps machines to new numbers of names.
  void rename(const NameTable& before, const NameTable& now);

  // Of the last start().
  std::span<const ActionRecord> records() const { return records_; }
  std::span<const StartedAction> started() const { return started_; }

  /// Numbers of names in the records of the last frame stay those of that frame.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.values_, self.actions_, self.last_id_, self.refused_);
    if constexpr (Archive::kReads) check_fits(self.values_, self.actions_, *self.declared_);
  }

 private:
  void begin(const ActionRequest& request, double time);
  void note_refusals(std::span<const ActionRequest> requests, double time);

  std::shared_ptr<const ApplicationInterface> declared_;
  std::vector<ValueState> values_;
  std::vector<ActionStatus> actions_;
  std::uint32_t last_id_ = 0;
  std::vector<RefusedAction> refused_;  ///< at most one for each machine and action
  std::vector<ActionRecord> records_;
  std::vector<StartedAction> started_;
};

}  // namespace reorient
