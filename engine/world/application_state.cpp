// SPDX-License-Identifier: MIT
#include "engine/world/application_state.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "geometry/bytes.h"

namespace reorient {
namespace {

// As in the state machines: thirty frames of 1/30 s count as one second.
constexpr double kRounding = 1e-6;

void enter(ActionStatus& status, ActionState state, double time, std::string reason = {}) {
  if (state != status.state) status.since = time;
  status.state = state;
  status.reason = std::move(reason);
}

}  // namespace

ApplicationState::ApplicationState(ApplicationInterface declared)
    : declared_(std::make_shared<const ApplicationInterface>(std::move(declared))) {
  if (const std::string mistake = mistake_in(*declared_); !mistake.empty())
    throw std::runtime_error("interface '" + declared_->name + "': " + mistake);
  for (const DeclaredValue& value : declared_->values) {
    ValueState& state = values_.emplace_back();
    if (value.is_list()) {
      state.records = 0;
    } else {
      state.data = value.fields.front().initial;
    }
  }
  actions_.resize(declared_->actions.size());
}

bool is_valid(const ValueState& state, const DeclaredValue& declared, double time) {
  return state.fits && std::isfinite(state.set_at) && time - state.set_at <= declared.lasts + kRounding;
}

void ApplicationState::begin_frame(double time) {
  records_.clear();
  started_.clear();
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const DeclaredAction& declared = declared_->actions[i];
    ActionStatus& status = actions_[i];
    if (!is_under_way(status.state) || time - status.started_at + kRounding < declared.takes) continue;
    if (!declared.reports) {
      enter(status, ActionState::done, time);
    } else if (declared.takes > 0.0) {
      enter(status, ActionState::failed, time, "the application did not report an end in time");
    }
  }
}

void ApplicationState::take(std::span<const SetValue> set, double time, std::vector<std::string>& mistakes) {
  for (const SetValue& one : set.first(std::min(set.size(), kMostSetValues))) {
    if (one.value >= values_.size()) continue;
    const DeclaredValue& declared = declared_->values[one.value];
    ValueState& state = values_[one.value];
    const std::uint32_t most = declared.is_list() ? declared.most : 1;
    std::string mistake;
    if (one.records > most || (one.records != 1 && !declared.is_list())) {
      mistake = "expected at most " + std::to_string(most) + " records, found " + std::to_string(one.records);
    } else {
      mistake = mistake_in(one.data, declared.fields, one.records);
    }
    const bool fitted = std::exchange(state.fits, mistake.empty());
    if (state.fits) {
      state.set_at = time;
      if (state.records == one.records && state.data == one.data) continue;
      state.records = one.records;
      state.data = one.data;
      ++state.revision;
    } else if (fitted) {
      mistakes.push_back("input." + declared.name + ": " + mistake);
    }
  }
}

void ApplicationState::take(std::span<const ActionReport> reports, double time) {
  for (const ActionReport& report : reports.first(std::min(reports.size(), kMostReports))) {
    for (std::size_t i = 0; i < actions_.size(); ++i) {
      ActionStatus& status = actions_[i];
      if (report.id == 0 || status.id != report.id || !is_under_way(status.state) || !declared_->actions[i].reports)
        continue;
      if (report.state == ActionState::idle || report.state == ActionState::requested) continue;
      enter(status, report.state, time, report.reason.substr(0, kLongestFieldText));
    }
  }
}

void ApplicationState::start(std::span<const ActionRequest> requests, double time) {
  records_.clear();
  started_.clear();
  for (const ActionRequest& request : requests) {
    if (continues(request.action, request.arguments)) continue;
    const bool runs = is_under_way(actions_[request.action].state);
    const auto rival = std::find_if(records_.begin(), records_.end(), [&](const ActionRecord& other) {
      return other.request.action == request.action && other.verdict == Verdict::granted;
    });
    Verdict verdict = runs ? Verdict::too_soon : Verdict::granted;
    if (request.outranked_by != kNoName) {
      verdict = Verdict::outranked;
    } else if (rival != records_.end()) {  // at a tie the first wins
      const bool wins = request.priority > rival->request.priority;
      (wins ? rival->verdict : verdict) = Verdict::outranked;
    }
    records_.push_back({request, verdict});
  }
  for (const ActionRecord& record : records_) {
    if (record.verdict == Verdict::granted) begin(record.request, time);
  }
  note_refusals(requests, time);
}

/// A request without a record continues what runs.
void ApplicationState::note_refusals(std::span<const ActionRequest> requests, double time) {
  for (const ActionRequest& request : requests) {
    const NameId machine = request.issuer.machine;
    std::erase_if(refused_,
                  [&](const RefusedAction& one) { return one.machine == machine && one.action == request.action; });
  }
  for (const ActionRecord& record : records_) {
    if (record.verdict == Verdict::granted) continue;
    const auto winner = std::find_if(records_.begin(), records_.end(), [&](const ActionRecord& other) {
      return other.request.action == record.request.action && other.verdict == Verdict::granted;
    });
    NameId by = record.request.outranked_by;
    if (by == kNoName && winner != records_.end()) by = winner->request.issuer.machine;
    const NameId machine = record.request.issuer.machine;
    // A behavior that requests an action twice has outranked itself.
    if (by != machine && refused(machine, record.request.action) == nullptr)
      refused_.push_back({machine, record.request.action, by, time});
  }
}

const RefusedAction* ApplicationState::refused(NameId machine, std::size_t action) const {
  const auto found = std::find_if(refused_.begin(), refused_.end(), [&](const RefusedAction& one) {
    return one.machine == machine && one.action == action;
  });
  return found == refused_.end() ? nullptr : &*found;
}

void ApplicationState::rename(const NameTable& before, const NameTable& now) {
  for (ActionStatus& status : actions_) status.issuer = renumbered(status.issuer, before, now);
  for (RefusedAction& one : refused_) {
    one.machine = renumbered(one.machine, before, now);
    one.outranked_by = renumbered(one.outranked_by, before, now);
  }
  std::erase_if(refused_, [](const RefusedAction& one) { return one.machine == kNoName; });
}

void ApplicationState::begin(const ActionRequest& request, double time) {
  ActionStatus& status = actions_[request.action];
  const bool reports = declared_->actions[request.action].reports;
  status = {++last_id_,
            reports ? ActionState::requested : ActionState::running,
            time,
            time,
            {},
            request.arguments,
            request.issuer,
            request.priority};
  started_.push_back({status.id, request.action, request.arguments});
}

void check_fits(std::span<const ValueState> values, std::span<const ActionStatus> actions,
                const ApplicationInterface& declared) {
  check_bytes(values.size() == declared.values.size() && actions.size() == declared.actions.size(),
              "application: expected the values and actions of its interface");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DeclaredValue& value = declared.values[i];
    const bool fits_list = value.is_list() ? values[i].records <= value.most : values[i].records == 1;
    check_bytes(fits_list && mistake_in(values[i].data, value.fields, values[i].records).empty(),
                "application: a value does not fit its declaration");
  }
  for (std::size_t i = 0; i < actions.size(); ++i) {
    check_bytes(actions[i].id == 0 || mistake_in(actions[i].arguments, declared.actions[i].arguments).empty(),
                "application: the arguments of an action do not fit its declaration");
  }
}

}  // namespace reorient
