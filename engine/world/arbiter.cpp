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
  const std::optional<double>& before = granted_at_[index_of(request.reorientation)];
  if (before && world.time - *before + kTimeTolerance < cooldown(request.reorientation)) return Verdict::too_soon;
  return Verdict::granted;
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
  const auto renamed = [&](NameId id) { return now.find(before[id]).value_or(kNoName); };
  for (Lease& lease : held_)
    lease.issuer = {renamed(lease.issuer.machine), renamed(lease.issuer.state), renamed(lease.issuer.reason)};
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
  return result_;
}

}  // namespace reorient
