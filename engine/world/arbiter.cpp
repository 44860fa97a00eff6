// SPDX-License-Identifier: MIT
#include "engine/world/arbiter.h"

#include <algorithm>

namespace reorient {
namespace {

// As in the state machines: thirty frames of 1/30 s count as one second.
constexpr double kTimeTolerance = 1e-6;

bool is_same(const Lease& left, const Lease& right) {
  return left.pause == right.pause && left.issuer.machine == right.issuer.machine &&
         left.issuer.state == right.issuer.state;
}

template <typename Verdicts>
auto find_last(Verdicts& verdicts, NameId machine, Reorientation reorientation) {
  return std::find_if(verdicts.begin(), verdicts.end(), [&](const LastVerdict& last) {
    return last.machine == machine && last.reorientation == reorientation;
  });
}

std::size_t index_of(Reorientation reorientation) { return static_cast<std::size_t>(reorientation); }

}  // namespace

double Arbiter::cooldown(Reorientation reorientation) const {
  switch (reorientation) {
    case Reorientation::flip_pose:
      return parameters_.flip_cooldown;
    case Reorientation::purge_reflection:
      return parameters_.purge_cooldown;
    case Reorientation::reset_orientation:
      return parameters_.reset_cooldown;
  }
  return 0.0;
}

/// Ignores other requests.
Verdict Arbiter::judge(const ReorientationRequest& request, const World& world) const {
  if (world.posture == Posture::lifted) return Verdict::not_allowed;
  if (!world.upright() && request.reorientation != Reorientation::reset_orientation) return Verdict::not_allowed;
  return wait(request.reorientation, world.time) > kTimeTolerance ? Verdict::too_soon : Verdict::granted;
}

double Arbiter::wait(Reorientation reorientation, double time) const {
  const std::optional<double>& before = granted_at_[index_of(reorientation)];
  return before ? std::max(0.0, *before + cooldown(reorientation) - time) : 0.0;
}

const LastVerdict* Arbiter::last_verdict(NameId machine, Reorientation reorientation) const {
  const auto found = find_last(verdicts_, machine, reorientation);
  return found == verdicts_.end() ? nullptr : &*found;
}

void Arbiter::note_verdicts() {
  for (const CommandRecord& command : result_.commands) {
    const NameId machine = command.request.issuer.machine;
    const Reorientation reorientation = command.request.reorientation;
    auto last = find_last(verdicts_, machine, reorientation);
    if (last == verdicts_.end())
      last = verdicts_.insert(last, LastVerdict{.machine = machine, .reorientation = reorientation});
    last->verdict = command.verdict;
    const bool is_outranked = command.verdict == Verdict::outranked;
    last->outranked_by = is_outranked ? result_.granted->request.issuer.machine : kNoName;
    last->refusals = command.verdict == Verdict::granted ? 0 : last->refusals + 1;
  }
}

void Arbiter::note_leases(std::span<const Lease> leases) {
  result_.train = true;
  result_.evaluate = true;
  result_.begun.clear();
  for (const Lease& lease : leases) {
    (lease.pause == Pause::training ? result_.train : result_.evaluate) = false;
    const auto same = [&](const Lease& held) { return is_same(held, lease); };
    if (std::none_of(held_.begin(), held_.end(), same)) result_.begun.push_back(lease);
  }
  held_.assign(leases.begin(), leases.end());
}

void Arbiter::rename(const NameTable& before, const NameTable& now) {
  for (Lease& lease : held_) lease.issuer = renumbered(lease.issuer, before, now);
  for (LastVerdict& last : verdicts_) {
    last.machine = renumbered(last.machine, before, now);
    last.outranked_by = renumbered(last.outranked_by, before, now);
  }
  std::erase_if(verdicts_, [](const LastVerdict& last) { return last.machine == kNoName; });  // it exists no more
}

const Arbitration& Arbiter::arbitrate(std::span<const ReorientationRequest> requests, std::span<const Lease> leases,
                                      const World& world) {
  note_leases(leases);
  result_.granted.reset();
  result_.commands.clear();
  CommandRecord* winner = nullptr;
  result_.commands.reserve(requests.size());  // so that the pointer to the winner stays valid
  for (const ReorientationRequest& request : requests) {
    CommandRecord& record = result_.commands.emplace_back(CommandRecord{request, judge(request, world)});
    if (record.verdict != Verdict::granted) continue;
    if (winner == nullptr || request.priority > winner->request.priority) {
      if (winner != nullptr) winner->verdict = Verdict::outranked;
      winner = &record;
    } else {
      record.verdict = Verdict::outranked;
    }
  }
  if (winner != nullptr) {
    result_.granted = *winner;
    granted_at_[index_of(winner->request.reorientation)] = world.time;
  }
  note_verdicts();
  return result_;
}

}  // namespace reorient
